// SH128 Motion: texture coordinates of a square.
#version 330 core

out vec2 vST;

void main() {
    vST = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
