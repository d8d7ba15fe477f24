// G11.f10 Control net: 48 vertices are the ends of its 24 lines, or the first 16 are the points.
#version 430 core

uniform mat4 mvp_matrix;
uniform vec3 uPoints[16];
uniform bool uAsPoints;

void main() {
    int line = gl_VertexID / 2, end = gl_VertexID % 2;
    int row = line % 12 / 3, step = line % 3 + end;
    int point = line < 12 ? 4 * row + step : 4 * step + row;
    gl_Position = mvp_matrix * vec4(uPoints[uAsPoints ? gl_VertexID : point], 1.);
}
