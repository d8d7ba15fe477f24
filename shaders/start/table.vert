// Start, the table: where on the table each fragment lies.
#version 330 core

out vec2 vPlace;   // x and z, model space

void main() {
    vPlace = aVertex.xz;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
