// SH082 Octant subdivision: corners in model space.
#version 400 compatibility

out vec4 vColor;

void main() {
    vColor = gl_Color;
    gl_Position = gl_Vertex;
}
