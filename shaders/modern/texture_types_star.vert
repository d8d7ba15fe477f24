// A star of thin prongs around the middle, three vertices each, from the numbers of the vertices.
#version 410 core

uniform int uProngs;

void main() {
    int corner = gl_VertexID % 3;
    float turn = 6.2831853*(float(gl_VertexID/3) + .5*float(corner - 1))/float(uProngs);
    float radius = corner == 1 ? .95 : .25;
    gl_Position = vec4(radius*vec2(sin(turn), cos(turn)), 0., 1.);
}
