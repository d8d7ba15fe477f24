// EX12.2 Superquad: strips of triangles over (1-s)(1-t) p0 + s (1-t) p1 + (1-s) t p2 + s t p3, with the normal of the surface.
#version 400 core

layout(lines_adjacency, invocations = 10) in;
layout(triangle_strip, max_vertices = 64) out;

uniform int uCells;   // 1 to 10 along each side
uniform bool uColors;

in vec3 vColor[];

out vec3 gColor;
out vec3 gNormal;     // eye space
out vec3 gPosition;   // eye space
out vec2 gCell;

vec3 corner(int i) {
    return gl_in[i].gl_Position.xyz;
}

void point(float s, float t) {
    vec3 low = mix(corner(0), corner(1), s), high = mix(corner(2), corner(3), s);
    gPosition = mix(low, high, t);
    gNormal = cross(high - low, mix(corner(1) - corner(0), corner(3) - corner(2), t));
    gColor = uColors ? mix(mix(vColor[0], vColor[1], s), mix(vColor[2], vColor[3], s), t) : vec3(.8);
    gCell = float(uCells) * vec2(s, t);
    gl_Position = uProjectionMatrix * vec4(gPosition, 1.);
    EmitVertex();
}

void main() {
    int row = gl_InvocationID;
    if (row >= uCells) return;
    float h = 1. / float(uCells);
    for (int i = 0; i <= uCells; ++i) {
        point(float(i) * h, float(row) * h);
        point(float(i) * h, float(row + 1) * h);
    }
    EndPrimitive();
}
