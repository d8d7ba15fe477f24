// SH074 Bezier: uNum pieces of the cubic through four clip-space points; the projection of a curve is the curve of
// the projections. Every parameter is i / uNum, so that the last piece ends at the last point.
#version 330
#extension GL_EXT_geometry_shader4 : enable

layout(lines_adjacency) in;
layout(line_strip, max_vertices = 64) out;

uniform int uNum;

in vec4 vColor[];

out vec4 gColor;

void main() {
    int pieces = clamp(uNum, 1, 63);
    for (int i = 0; i <= pieces; ++i) {
        float t = float(i) / float(pieces), s = 1. - t;
        gColor = vColor[0];
        gl_Position = s * s * s * gl_PositionIn[0] + 3. * s * s * t * gl_PositionIn[1] +
                      3. * s * t * t * gl_PositionIn[2] + t * t * t * gl_PositionIn[3];
        EmitVertex();
    }
    EndPrimitive();
}
