// G9.1 A cube map as one picture in the form of a cross.
#version 410 core
#include "cross.glsl"

uniform samplerCube uSky;

in vec2 vST;
out vec4 fColor;

void main() {
    vec2 place = vST * vec2(4., 3.);
    vec3 direction = crossDirection(ivec2(place), fract(place));
    fColor = vec4(direction == vec3(0.) ? vec3(0.) : texture(uSky, direction).rgb, 1.);
}
