// SH129 Motion: noise at s + Timer where the mask is dark, at s - Timer where it is bright. A whole number uSpeed closes the loop.
#version 330 core

uniform sampler2D uRandomUnit;
uniform sampler2D uMaskUnit;
uniform float uSpeed;
uniform bool uColored;

in vec2 vST;

out vec4 fColor;

void main() {
    float shift = (texture(uMaskUnit, vST).r > .5 ? -1. : 1.) * floor(uSpeed + .5) * Timer;
    vec2 st = vec2(fract(vST.s + shift), vST.t);
    // Whole texels: grains keep their edges while they move.
    vec2 size = vec2(textureSize(uRandomUnit, 0)) / 2.;
    ivec2 grain = ivec2(st * size) * 2;
    vec3 noise = texelFetch(uRandomUnit, grain, 0).rrr;
    if (uColored) noise = vec3(noise.r, texelFetch(uRandomUnit, grain.yx, 0).r, texelFetch(uRandomUnit, grain ^ 85, 0).r);
    fColor = vec4(step(.5, noise), 1.);
}
