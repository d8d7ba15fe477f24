// V03 Pass through: each vertex goes where the matrices say, in the current colour.
#version 110

void main() {
    gl_FrontColor = gl_Color;
    gl_Position = gl_ProjectionMatrix * gl_ModelViewMatrix * gl_Vertex;
}
