// S14 Position and colour go on to the geometry stage.
#version 120

void main() {
    gl_FrontColor = gl_Color;
    gl_Position = ftransform();
}
