// R31 The volume that a shadow may reach.
#version 330 core

void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }
