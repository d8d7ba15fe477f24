// SH081 Bezier surface: the lit colour.
#version 400

in vec4 gColor;

out vec4 fColor;

void main() {
    fColor = gColor;
}
