// SH028 Texture: the colour of the picture at the fragment, made darker or brighter.
#version 330 core

uniform sampler2D uImageUnit;
uniform float uBrightness;

in vec2 vST;

out vec4 fColor;

void main() {
    fColor = vec4(uBrightness * texture(uImageUnit, vST).rgb, 1.);
}
