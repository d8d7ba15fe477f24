// SH047 SH048 CMYK plates: how much ink of one of four colours a printer lays on each place of the paper.
#version 330 core

uniform sampler2D uImageUnit;
uniform int uPlate;          // 0 cyan, 1 magenta, 2 yellow, 3 black
uniform bool uReduced;       // black ink only in dark places, and a tenth less of the others there
uniform bool uColored;       // ink in its colour, or dark grey for much ink

in vec2 vST;

out vec4 fColor;

vec4 inks(vec3 rgb) {
    vec3 cmy = 1. - rgb;
    float k = min(cmy.r, min(cmy.g, cmy.b));
    if (uReduced) return vec4(cmy - .1 * k, k < .3 ? 0. : .9 * (k - .3) / .7);
    // Pure black has no colour left to print, so the quotient 0/0 becomes 0.
    return vec4(k < 1. ? (cmy - k) / (1. - k) : vec3(0.), k);
}

void main() {
    float ink = clamp(inks(texture(uImageUnit, vST).rgb)[uPlate], 0., 1.);
    vec3 absorbed = uColored && uPlate < 3 ? vec3(equal(ivec3(0, 1, 2), ivec3(uPlate))) : vec3(1.);
    fColor = vec4(1. - ink * absorbed, 1.);
}
