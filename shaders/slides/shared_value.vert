// S22 The model's own coordinates.
#version 400

void main() { gl_Position = aVertex; }
