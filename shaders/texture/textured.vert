// SH027 Texture: the texture coordinates pass through.
#version 330 core

out vec2 vST;

void main() {
    vST = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
