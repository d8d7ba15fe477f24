// One colour.
#version 430 core

uniform vec4 uColor;

out vec4 fColor;

void main() {
    fColor = uColor;
}
