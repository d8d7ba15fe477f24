// R37 Sums of noise: each octave is finer by the lacunarity and weaker by the gain.
#version 330 core
#include "gradient.glsl"

uniform int uKind;              // fbm, turbulence, ridged, multifractal
uniform int uOctaves;
uniform float uLacunarity;      // how much finer the next octave is
uniform float uGain;            // how strong the next octave is
uniform float uFrequency;       // of the first octave

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 place = vec3(uFrequency * vST + .31, .37);
    float amplitude = 1., sum = 0., product = 1., weight = 1.;
    for (int k = 0; k < uOctaves; k++) {
        float value = gradientNoise(place);
        if (uKind == 0) sum += amplitude * value;
        else if (uKind == 1) sum += amplitude * abs(value);
        else if (uKind == 2) {
            // A ridge where the noise is 0; the next octave is strong on ridges only.
            float ridge = (1. - abs(value)) * (1. - abs(value)) * weight;
            weight = clamp(2. * ridge, 0., 1.);
            sum += amplitude * ridge * .6;
        } else {
            product *= 1. + 2. * amplitude * value;
        }
        place = place * uLacunarity + 17.;
        amplitude *= uGain;
    }
    float grey = uKind == 0 ? .5 + .9 * sum : uKind == 1 ? 1.2 * sum : uKind == 2 ? sum - .1 : .5 * product;
    fColor = vec4(vec3(clamp(grey, 0., 1.)), 1.);
}
