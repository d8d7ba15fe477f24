// The direction of each point of a sky box.
#version 330 core

out vec3 vDirection;

void main() {
    vDirection = aVertex.xyz;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
