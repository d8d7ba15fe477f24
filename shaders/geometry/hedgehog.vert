// SH112 Hedgehog: the model position, and the normal along which the hair grows.
#version 330 core

out vec3 vNormal;

void main() {
    vNormal = aNormal;
    gl_Position = aVertex;
}
