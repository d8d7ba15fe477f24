// G10.3 Colour map of the Moon from its height map: the plains are dark, the hills bright.
#version 430 core
#include "noise.glsl"

uniform sampler2D heightMap;

in vec2 vST;
out vec4 fColor;

void main() {
    float plain = smoothstep(-.03, .03, texture(heightMap, vST).r);
    float dust = .1 * gradientNoise(vec3(64. * vST, 0.), 64);
    fColor = vec4((mix(.42, .74, plain) + dust) * vec3(1., .98, .94), 1.);
}
