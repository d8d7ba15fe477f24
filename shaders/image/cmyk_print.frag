// SH047 The print: the four plates on one paper. Each ink takes its share of what the others leave.
#version 330 core

uniform sampler2D uCyan, uMagenta, uYellow, uBlack;

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 left = vec3(texture(uCyan, vST).r, texture(uMagenta, vST).r, texture(uYellow, vST).r);
    fColor = vec4(left * texture(uBlack, vST).r, 1.);
}
