// Patches: the number of the instance places a patch in the square -1..1, the number of the vertex its corner.
#version 410 core

uniform int uPatches;

void main() {
    vec2 cell = vec2(gl_InstanceID % uPatches, gl_InstanceID / uPatches) + vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(2. * cell.x / float(uPatches) - 1., 0., 1. - 2. * cell.y / float(uPatches), 1.);
}
