// SH078 Bezier curve: control points in model space.
#version 400

out vec4 vColor;

void main() {
    vColor = aColor;
    gl_Position = aVertex;
}
