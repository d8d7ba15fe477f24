// SH077 Silhouettes: eye space, where the facing of a triangle is decided.
#version 330 core

void main() {
    gl_Position = uModelViewMatrix * aVertex;
}
