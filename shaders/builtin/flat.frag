// The fragment stage for geometry without a program: its colour, without light.
#version 410 core

in vec4 vColor;
out vec4 fColor;

void main() {
    fColor = vColor;
}
