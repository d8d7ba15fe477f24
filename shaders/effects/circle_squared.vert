// SH127 Circle squared: only the place in the window matters.
#version 330 core

void main() {
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
