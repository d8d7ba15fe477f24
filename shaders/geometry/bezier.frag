// SH074 Bezier: the colour as it is.
#version 330 core

in vec4 gColor;

out vec4 fColor;

void main() {
    fColor = gColor;
}
