// G14.1 Height map of hills, which repeats in both directions.
#version 430 core
#include "noise.glsl"

in vec2 vST;
out float fHeight;

void main() {
    float sum = 0., amplitude = 1.;
    for (int period = 4; period <= 128; period *= 2, amplitude *= .48)
        sum += amplitude * gradientNoise(vec3(float(period) * vST, .5), period);
    fHeight = .5 + .6 * sum;
}
