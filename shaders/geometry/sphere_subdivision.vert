// SH076 Sphere subdivision: passes the model position on; the geometry stage transforms it.
#version 330 core

out vec4 vColor;

void main() {
    vColor = aColor;
    gl_Position = aVertex;
}
