// Flat colours: one corner of each triangle decides for all of it.
#version 330 core

flat out vec4 vColor;

void main() {
    vColor = aColor;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
