// SH031 D09 Fractals: the texture square is the window into the complex plane.
#version 330 core

out vec2 vST;

void main() {
    vST = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
