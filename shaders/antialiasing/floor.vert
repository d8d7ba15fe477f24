// A floor or wall with coordinates for its pattern.
#version 330 core

out vec2 vPlace;

void main() {
    vPlace = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
