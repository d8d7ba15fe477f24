// S23 Corners in clip space: no matrix.
#version 410 core

in vec4 aVertex;

void main() { gl_Position = aVertex; }
