// R19 A panorama of a sky box: all directions in one picture, twice as wide as high.
#version 330 core
#include "../common/direction.glsl"

uniform samplerCube uSky;

in vec2 vST;
out vec4 fColor;

void main() { fColor = vec4(texture(uSky, directionAt(vST)).rgb, 1.); }
