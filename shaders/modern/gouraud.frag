// G7.1 Gouraud shading: the interpolated light.
#version 430 core

in vec3 vColor;
out vec4 fColor;

void main() {
    fColor = vec4(vColor, 1.);
}
