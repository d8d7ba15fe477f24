// SH052 Anaglyph: red from the left eye's picture, green and blue from the right eye's.
#version 330 core

uniform float uOffsetS, uOffsetT;        // moves the right picture
uniform float uRed, uGreen, uBlue;
uniform sampler2D uLeftUnit;
uniform sampler2D uRightUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    float red = texture(uLeftUnit, vST).r;
    vec2 cyan = texture(uRightUnit, vST + vec2(uOffsetS, uOffsetT)).gb;
    fColor = vec4(clamp(vec3(red, cyan) * vec3(uRed, uGreen, uBlue), 0., 1.), 1.);
}
