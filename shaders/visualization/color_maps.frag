// EX15.1 Colour maps: a slice of the field above, and below it the bar of the map from 0 to 100.
#version 330 core

#include "../common/rainbow.glsl"

uniform sampler3D uField;
uniform float uSlice;   // -1..1
uniform float uTol;     // half the width of a contour, in units of the field
uniform int uMap;

in vec2 vST;

out vec4 fColor;

vec3 colorOf(float value) {
    float t = clamp(value / 100., 0., 1.);
    if (uMap == 0) {   // rainbow with a contour at every ten units
        float away = abs(value - 10. * floor(value / 10. + .5)), wide = .5 * fwidth(value);
        return mix(.25, 1., smoothstep(uTol - wide, uTol + wide + 1e-6, away)) * rainbow(t);
    }
    if (uMap == 1) return heatedObject(t);
    if (uMap == 2) return vec3(t);
    if (uMap == 3) return mix(vec3(.05, .10, .55), vec3(1., .92, .25), t);
    if (uMap == 4) return t < .5 ? mix(vec3(.15, .30, .80), vec3(.93), 2. * t) : mix(vec3(.93), vec3(.80, .12, .15), 2. * t - 1.);
    // Ten steps of hue, each from dark to bright: small differences show.
    float step = floor(min(10. * t, 9.)), inStep = 10. * t - step;
    return (.45 + .55 * inStep) * rainbow(step / 9.);
}

void main() {
    if (vST.t < .12) {
        fColor = vec4(vST.t > .08 ? vec3(.10, .11, .13) : colorOf(100. * vST.s), 1.);
        return;
    }
    float value = texture(uField, vec3(vST.s, (vST.t - .12) / .88, .5 + .5 * uSlice)).r;
    fColor = vec4(colorOf(value), 1.);
}
