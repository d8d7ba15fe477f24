// What draws geometry that has no program: its colour, no light.
#version 410 core

in vec4 vColor;
out vec4 fColor;

void main() {
    fColor = vColor;
}
