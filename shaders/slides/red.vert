// S01 A red shape: the colour of the vertex is the colour of all its pixels.
#version 110

void main() {
    gl_FrontColor = vec4(1., 0., 0., 1.);
    gl_Position = ftransform();
}
