// A square that carries a picture.
#version 330 core

out vec2 vST;

void main() {
    vST = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
