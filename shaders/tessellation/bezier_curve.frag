// SH079 Bezier curve: the plain colour.
#version 400

in vec4 teColor;

out vec4 fColor;

void main() {
    fColor = teColor;
}
