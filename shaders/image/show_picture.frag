// A picture as it is.
#version 330 core

uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    fColor = vec4(texture(uImageUnit, vST).rgb, 1.);
}
