// EX13.2 Cracks: the four corners of a square.
#version 400 core

void main() {
    gl_Position = vec4(float(gl_VertexID & 1), 0., float(gl_VertexID >> 1), 1.);
}
