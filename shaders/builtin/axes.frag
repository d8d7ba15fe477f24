// The axes of --axes: each in its own colour.
#version 410 core

in vec3 vColor;
out vec4 fColor;

void main() {
    fColor = vec4(vColor, 1.0);
}
