// G11.f7 The straight pieces of a curve from one point: a line strip with a colour for each level of division.
#version 410 core
#include "subdivide.glsl"

layout(points) in;
layout(line_strip, max_vertices = 65) out;

uniform mat4 mvp_matrix;

flat out int vLevel;

void emit(vec2 place, int level) {
    gl_Position = mvp_matrix * vec4(place, 0., 1.);
    vLevel = level;
    EmitVertex();
}

void main() {
    Curve stack[kLevels + 1];
    int top = 0;
    stack[0] = Curve(uPoints[0], uPoints[1], uPoints[2], uPoints[3], 0);
    emit(uPoints[0], 0);
    while (top >= 0) {
        Curve c = stack[top--];
        if (isStraight(c)) {
            emit(c.p3, c.level);
        } else {
            Curve left, right;
            halves(c, left, right);
            stack[++top] = right;
            stack[++top] = left;
        }
    }
}
