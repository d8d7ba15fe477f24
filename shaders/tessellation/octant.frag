// SH093 Octant subdivision: the lit colour.
#version 400 compatibility

in vec4 gColor;

out vec4 fColor;

void main() {
    fColor = gColor;
}
