// Corners with colours of their own: the colour is interpolated between them.
#version 330 core

out vec4 vColor;

void main() {
    vColor = aColor;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
