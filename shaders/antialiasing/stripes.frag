// R50 Stripes: four ways to draw the same stripes, which differ in what they do where stripes are narrower than pixels.
#version 330 core
#include "pulse.glsl"

uniform int uQuality;       // sharp, smoothstep, adaptive, integrated
uniform float uFrequency;   // stripes along the lower edge
uniform float uGrowth;      // how many times their number doubles up to the upper edge
uniform float uDuty;        // share of a period that is light
uniform float uFuzz;        // width of the edge of smoothstep, in periods

in vec2 vPlace;

out vec4 fColor;

// Edges of the width w about 0 and duty.
float smoothPulse(float x, float w) {
    float s = fract(x + .5 * (1. - uDuty)) - .5 * (1. - uDuty);
    return smoothstep(-w / 2., w / 2., s) - smoothstep(uDuty - w / 2., uDuty + w / 2., s);
}

void main() {
    float x = (vPlace.s - .5) * uFrequency * exp2(uGrowth * vPlace.t);
    // How much x changes from pixel to pixel.
    float w = max(length(vec2(dFdx(x), dFdy(x))), 1e-5);
    float light;
    if (uQuality == 0) {
        light = fract(x) < uDuty ? 1. : 0.;
    } else if (uQuality == 1) {
        light = smoothPulse(x, uFuzz);
    } else if (uQuality == 2) {
        // Edges as wide as a pixel. Where these fill a period, the mean takes over.
        light = mix(smoothPulse(x, min(w, .5)), uDuty, smoothstep(.4, 1., w));
    } else {
        light = pulseMean(x, w, uDuty);
    }
    fColor = vec4(mix(vec3(.09, .2, .38), vec3(.98, .88, .6), light), 1.);
}
