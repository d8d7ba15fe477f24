// G2.5 G2.6 Sliding triangle: the number of the vertex selects the corner.
#version 430 core

uniform float uOffset;

const vec2 kCorners[3] = vec2[](vec2(.25, -.25), vec2(-.25, -.25), vec2(.25, .25));

void main() {
    vec2 corner = kCorners[gl_VertexID];
    gl_Position = vec4(corner.x + uOffset, corner.y, 0., 1.);
}
