// SH120 Rainbow: the place in the picture, as texture coordinate and as -1..1.
#version 330 core

out vec2 vST;
out vec2 vXY;

void main() {
    vST = aTexCoord0.st;
    vXY = aVertex.xy;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
