// Corners with colours of their own: each pixel shows what was interpolated.
#version 330 core

in vec4 vColor;

out vec4 fColor;

void main() {
    fColor = vColor;
}
