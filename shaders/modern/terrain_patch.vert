// G12.4 Terrain: the instance number places a patch in the square -.5...5, the vertex number its corner.
#version 430 core

uniform int uPatches;

out vec2 vCorner;

void main() {
    vec2 cell = vec2(gl_InstanceID % uPatches, gl_InstanceID / uPatches);
    vCorner = (cell + vec2(gl_VertexID & 1, gl_VertexID >> 1)) / float(uPatches);
    gl_Position = vec4(vCorner.x - .5, 0., .5 - vCorner.y, 1.);
}
