// R19 The surroundings, from the same panorama.
#version 330 core
#include "../common/direction.glsl"

uniform sampler2D uPanorama;

in vec3 vModel;
out vec4 fColor;

void main() { fColor = vec4(textureLod(uPanorama, placeOf(vModel), 0.).rgb, 1.); }
