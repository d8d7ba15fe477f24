// Start, the compute shader: vertex i is element i of the buffer.
#version 430 core

struct Place {
    vec4 point;
};
layout(std430) readonly buffer Places { Place places[]; };

uniform mat4 mvp_matrix;

out float vHeight;

void main() {
    vHeight = places[gl_VertexID].point.y;
    gl_Position = mvp_matrix * places[gl_VertexID].point;
}
