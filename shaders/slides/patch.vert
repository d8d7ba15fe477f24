// Corners of a patch, as they are.
#version 400

void main() { gl_Position = aVertex; }
