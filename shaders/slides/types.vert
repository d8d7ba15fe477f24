// S16 Points in the panel.
#version 150

void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }
