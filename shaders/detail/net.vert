// G11.f9 G11.f10 A net of n x n control points: two vertices for each of its 2*n*(n - 1) lines, or the points themselves.
#version 410 core

uniform mat4 mvp_matrix;
uniform vec3 uPoints[16];
uniform int uSide;          // n
uniform bool uAsPoints;

void main() {
    int perRow = uSide - 1, line = gl_VertexID / 2, end = gl_VertexID % 2;
    bool isColumn = line >= uSide * perRow;
    int row = line % (uSide * perRow) / perRow, step = line % perRow + end;
    int point = isColumn ? uSide * step + row : uSide * row + step;
    gl_Position = mvp_matrix * vec4(uPoints[uAsPoints ? gl_VertexID : point], 1.);
}
