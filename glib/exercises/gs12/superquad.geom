// Exercise EX12.2: the four corners of a line with adjacency as two triangles.
#version 330 core

layout(lines_adjacency) in;
layout(triangle_strip, max_vertices = 64) out;

uniform int uCells;
uniform bool uColors;

in vec3 vColor[];

out vec3 gColor;
out vec3 gNormal;     // eye space
out vec3 gPosition;   // eye space
out vec2 gCell;       // 0..uCells, where the lines are drawn

void main() {
    for (int i = 0; i < 4; ++i) {
        gPosition = gl_in[i].gl_Position.xyz;
        gNormal = uNormalMatrix * vec3(0., 1., 0.);   // <- of the surface
        gColor = uColors ? vColor[i] : vec3(.8);
        gCell = float(uCells) * vec2(i & 1, i >> 1);
        gl_Position = uProjectionMatrix * gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
