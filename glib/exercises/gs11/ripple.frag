// The picture as it is. Exercise: let it ripple.
#version 330 core

uniform float uAx, uAy;     // how far, in pixels of the picture
uniform float uTx, uTy;     // length of a wave, in pixels of the picture
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 size = vec2(textureSize(uImageUnit, 0));
    vec2 xy = vST * size;
    // Here xy is the pixel that is drawn. It moves equally far everywhere, and hardly at all. Make it a wave.
    xy += vec2(uAx / uTx, uAy / uTy);
    fColor = vec4(texture(uImageUnit, xy / size).rgb, 1.);
}
