// SH056 Toon: black where the Sobel gradient of the luminance is large, otherwise each colour rounded to multiples of 1 / uQuantize.
#version 330 core

uniform float uMagTol;
uniform float uQuantize;
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

float luminance(int s, int t) {
    vec2 step = 1. / vec2(textureSize(uImageUnit, 0));
    return dot(texture(uImageUnit, vST + vec2(s, t) * step).rgb, vec3(.2125, .7154, .0721));
}

void main() {
    float p00 = luminance(-1, -1), p10 = luminance(0, -1), p20 = luminance(1, -1);
    float p01 = luminance(-1, 0), p21 = luminance(1, 0);
    float p02 = luminance(-1, 1), p12 = luminance(0, 1), p22 = luminance(1, 1);
    float across = p20 + 2. * p21 + p22 - p00 - 2. * p01 - p02;
    float up = p02 + 2. * p12 + p22 - p00 - 2. * p10 - p20;

    vec3 color = texture(uImageUnit, vST).rgb;
    fColor = vec4(length(vec2(across, up)) > uMagTol ? vec3(0.) : floor(color * uQuantize + .5) / uQuantize, 1.);
}
