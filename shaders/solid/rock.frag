// G14.1 A picture of rock, which repeats: patches, and dark cracks between them.
#version 410 core
#include "modern/noise.glsl"

in vec2 vST;
out vec4 fColor;

void main() {
    float sum = 0., amplitude = 1.;
    for (int period = 8; period <= 64; period *= 2, amplitude *= .5)
        sum += amplitude * gradientNoise(vec3(float(period) * vST, .5), period);
    float crack = smoothstep(0., .1, abs(gradientNoise(vec3(8. * vST, 3.5), 8) + .3 * sum));
    fColor = vec4(mix(.5, 1., crack) * (.85 + .3 * sum) * vec3(.56, .49, .42), 1.);
}
