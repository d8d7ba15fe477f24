// SH020 Flat shading: one intensity per triangle.
#version 330 core

uniform vec3 uColor;

flat in float vIntensity;

out vec4 fColor;

void main() {
    fColor = vec4(vIntensity * uColor, 1.);
}
