// A solid whose pattern comes from its own coordinates.
#version 330 core

out vec3 vPlace;
out vec3 vNormal;

void main() {
    vPlace = aVertex.xyz;
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
