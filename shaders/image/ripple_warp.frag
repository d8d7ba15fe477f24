// EX11.10 Ripple: rows swing to the side and columns up and down, by sines that are counted in pixels of the picture.
#version 330 core

uniform float uAx, uAy;     // how far, in pixels
uniform float uTx, uTy;     // length of a wave, in pixels
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    const float twoPi = 6.2831853;
    vec2 size = vec2(textureSize(uImageUnit, 0));
    vec2 xy = vST * size;
    xy += vec2(uAx * sin(twoPi * xy.y / uTx), uAy * sin(twoPi * xy.x / uTy));
    fColor = vec4(texture(uImageUnit, xy / size).rgb, 1.);
}
