// The axes of --axes, in white as in the original.
#version 410 core

out vec4 fColor;

void main() {
    fColor = vec4(1.0);
}
