// G2.2 Point: the middle of the window, without any vertex data.
#version 430 core

void main() {
    gl_Position = vec4(0., 0., 0., 1.);
}
