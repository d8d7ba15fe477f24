// G11.f3 Points of a list as dots.
#version 410 core

uniform mat4 mvp_matrix;
uniform vec2 uPoints[4];

void main() {
    gl_Position = mvp_matrix * vec4(uPoints[gl_VertexID], 0., 1.);
}
