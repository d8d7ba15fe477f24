// G11.f9 Control points of a patch, by the number of the vertex.
#version 410 core

uniform vec3 uPoints[16];

void main() {
    gl_Position = vec4(uPoints[gl_VertexID], 1.);
}
