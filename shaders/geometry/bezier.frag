// SH074 Bezier: the plain colour.
#version 330 core

in vec4 gColor;

out vec4 fColor;

void main() {
    fColor = gColor;
}
