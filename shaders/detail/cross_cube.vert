// G9.1 A cube whose faces have texture coordinates in a cross of 4 x 3 cells; 36 vertices without data.
#version 410 core
#include "cross.glsl"

uniform mat4 mvp_matrix;
uniform float uThird;       // the height of a cell: 1/3, or about that

out vec2 vST;

const ivec2 kCells[6] = ivec2[](ivec2(0, 1), ivec2(1, 1), ivec2(2, 1), ivec2(3, 1), ivec2(1, 2), ivec2(1, 0));
const vec2 kCorners[6] = vec2[](vec2(0., 0.), vec2(1., 0.), vec2(1., 1.), vec2(0., 0.), vec2(1., 1.), vec2(0., 1.));

void main() {
    ivec2 cell = kCells[gl_VertexID / 6];
    vec2 inside = kCorners[gl_VertexID % 6], grid = vec2(cell) + inside;
    vST = vec2(.25 * grid.x, grid.y == 3. ? 1. : uThird * grid.y);
    gl_Position = mvp_matrix * vec4(crossDirection(cell, inside), 1.);
}
