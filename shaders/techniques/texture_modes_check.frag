// R13 One value of each mode, for the check.
#version 330 core
#include "texture_mode.glsl"

uniform int uMode;
out vec4 fColor;

void main() { fColor = applyTexture(uMode, vec4(.8, .4, .2, 1.), vec4(.5, 1., 0., .25), vec3(0., 0., 1.)); }
