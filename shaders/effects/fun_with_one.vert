// SH122 Fun with one: the place in the picture, 4 x 3.
#version 330 core

out vec2 vXY;

void main() {
    vXY = vec2(4., 3.) * aVertex.xy;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
