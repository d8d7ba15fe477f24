// G11.f10 Control net: one colour.
#version 430 core

uniform vec4 uColor;

out vec4 fColor;

void main() {
    fColor = uColor;
}
