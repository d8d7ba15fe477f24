// Exercise EX15.1: a slice of the field above, and below it the bar of the map from 0 to 100.
#version 330 core

uniform sampler3D uField;
uniform float uSlice;   // -1..1
uniform float uTol;     // half the width of a contour, in units of the field
uniform int uMap;

in vec2 vST;

out vec4 fColor;

vec3 colorOf(float value) {
    float t = clamp(value / 100., 0., 1.);
    if (uMap == 0) return abs(value - 50.) < uTol ? vec3(0.) : vec3(t);   // one contour, at 50
    // <- the other maps
    return vec3(t);
}

void main() {
    if (vST.t < .12) {
        fColor = vec4(vST.t > .08 ? vec3(.10, .11, .13) : colorOf(100. * vST.s), 1.);
        return;
    }
    float value = texture(uField, vec3(vST.s, (vST.t - .12) / .88, .5 + .5 * uSlice)).r;
    fColor = vec4(colorOf(value), 1.);
}
