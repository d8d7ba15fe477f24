// A point per grain of the buffer.
#version 430 core

layout(std430) readonly buffer Dust { vec4 dust[]; };
uniform mat4 viewProjection;

void main() {
    gl_Position = viewProjection * vec4(dust[gl_VertexID].xyz, 1.);
}
