// Two triangles for each square of four points of the cloth.
#version 430 core

layout(std430) readonly buffer Cloth { vec4 points[]; };
uniform mat4 viewProjection;
uniform int uSide;

out vec3 vPlace;
out vec2 vSquare;

void main() {
    const ivec2 kCorners[6] = ivec2[](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(0, 1));
    int square = gl_VertexID / 6;
    ivec2 corner = ivec2(square % (uSide - 1), square / (uSide - 1)) + kCorners[gl_VertexID % 6];
    vPlace = points[corner.y * uSide + corner.x].xyz;
    vSquare = vec2(corner);
    gl_Position = viewProjection * vec4(vPlace, 1.);
}
