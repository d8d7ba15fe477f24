// Two triangles for each square of four points of the cloth, with their normal.
#version 430 core

layout(std430) readonly buffer Cloth { vec4 points[]; };
uniform mat4 viewProjection;
uniform int uSide;

flat out vec3 vNormal;
flat out ivec2 vSquare;

vec3 corner(ivec2 square, int number) {
    const ivec2 kCorners[6] = ivec2[](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(0, 1));
    ivec2 place = square + kCorners[number];
    return points[place.y * uSide + place.x].xyz;
}

void main() {
    int square = gl_VertexID / 6, number = gl_VertexID % 6, first = number / 3 * 3;
    vSquare = ivec2(square % (uSide - 1), square / (uSide - 1));
    vec3 start = corner(vSquare, first);
    vNormal = cross(corner(vSquare, first + 1) - start, corner(vSquare, first + 2) - start);
    gl_Position = viewProjection * vec4(corner(vSquare, number), 1.);
}
