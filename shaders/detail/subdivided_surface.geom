// G11.f10 One quad of a surface that is divided in four until flat. Each point stands for a square of the finest grid and goes
// the way of the recursion to it; the first square of each flat piece draws the piece.
#version 410 core

layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

uniform mat4 mvp_matrix;
uniform vec3 uPoints[16];
uniform float uTolerance;
uniform int uLevels;

in int vNumber[];
flat out int vLevel;
flat out vec3 vFace;

vec3 points[16];

/// The half of a row or column of four points, from `first` in steps, that belongs to t < 1/2 or t > 1/2.
void halve(int first, int stride, bool upper) {
    vec3 a = points[first], b = points[first + stride], c = points[first + 2 * stride], d = points[first + 3 * stride];
    vec3 ab = (a + b) / 2., bc = (b + c) / 2., cd = (c + d) / 2., abc = (ab + bc) / 2., bcd = (bc + cd) / 2.;
    vec3 middle = (abc + bcd) / 2.;
    points[first] = upper ? middle : a;
    points[first + stride] = upper ? bcd : ab;
    points[first + 2 * stride] = upper ? cd : abc;
    points[first + 3 * stride] = upper ? d : middle;
}

/// Whether all points lie within the tolerance of the plane Ax + By + Cz + D = 0 through three corners.
bool isFlat() {
    vec3 abc = cross(points[3] - points[0], points[12] - points[0]);
    float d = -dot(abc, points[0]), size = length(abc);
    if (size < 1e-9) return false;
    for (int i = 0; i < 16; ++i)
        if (abs(dot(abc, points[i]) + d) / size > uTolerance) return false;
    return true;
}

void main() {
    for (int i = 0; i < 16; ++i) points[i] = uPoints[i];
    int side = 1 << uLevels, x = vNumber[0] % side, y = vNumber[0] / side, level = 0;
    while (level < uLevels && !isFlat()) {
        ++level;
        int bit = 1 << (uLevels - level);
        for (int i = 0; i < 4; ++i) halve(4 * i, 1, (x & bit) != 0);
        for (int i = 0; i < 4; ++i) halve(i, 4, (y & bit) != 0);
    }
    int rest = (1 << (uLevels - level)) - 1;
    if ((x & rest) != 0 || (y & rest) != 0) return;

    const int kCorners[4] = int[](0, 12, 3, 15);
    vec3 normal = normalize(cross(points[15] - points[0], points[3] - points[12]));
    for (int i = 0; i < 4; ++i) {
        gl_Position = mvp_matrix * vec4(points[kCorners[i]], 1.);
        vLevel = level;
        vFace = normal;
        EmitVertex();
    }
}
