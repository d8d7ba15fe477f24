// SH093 Spheres: the lit colour.
#version 400 compatibility

in vec4 gColor;

out vec4 fColor;

void main() {
    fColor = gColor;
}
