// G12.1 One colour.
#version 410 core

uniform vec4 uColor;

out vec4 fColor;

void main() {
    fColor = uColor;
}
