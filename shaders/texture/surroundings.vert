// SH035 Surroundings: the direction from the middle of the box is the direction into the cube map.
#version 330 core

out vec3 vDirection;   // world space, because no transformation follows the view

void main() {
    vDirection = aVertex.xyz;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
