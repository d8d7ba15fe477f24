// EX15.1 Colour maps: a square, with 0..1 across it.
#version 330 core

out vec2 vST;

void main() {
    vST = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
