// Start, the table: the place of each fragment on the table.
#version 330 core

out vec2 vPlace;   // x and z, model space

void main() {
    vPlace = aVertex.xz;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
