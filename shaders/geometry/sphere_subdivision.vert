// SH076 Sphere subdivision: model space is left to the geometry stage.
#version 330 core

out vec4 vColor;

void main() {
    vColor = aColor;
    gl_Position = aVertex;
}
