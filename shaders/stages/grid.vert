// G12.1 Grid: a patch of one vertex without data.
#version 410 core

void main() {
    gl_Position = vec4(0., 0., 0., 1.);
}
