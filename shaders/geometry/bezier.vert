// SH074 Bezier: the four points in clip space.
#version 330 core

out vec4 vColor;

void main() {
    vColor = aColor;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
