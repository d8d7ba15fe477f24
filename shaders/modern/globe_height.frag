// G10.f15 Height map of a planet with seas: 0 is the level of the sea, 1 the highest mountain.
#version 430 core
#include "noise.glsl"

in vec2 vST;
out float fHeight;

void main() {
    vec2 angle = radians(mix(vec2(-180., -90.), vec2(180., 90.), vST));
    vec3 place = vec3(-cos(angle.x) * cos(angle.y), sin(angle.y), sin(angle.x) * cos(angle.y));
    float land = fractalNoise(1.6 * place + 5., 7);
    float ridges = 1. - abs(fractalNoise(4. * place + 20., 5));
    fHeight = smoothstep(0., .06, land) * clamp(.25 + 1.1 * land * ridges * ridges, 0., 1.);
}
