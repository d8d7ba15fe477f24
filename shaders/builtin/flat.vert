// The vertex stage for geometry without a program: it transforms the position and passes the colour on.
#version 410 core

uniform mat4 uModelViewProjectionMatrix;
in vec4 aVertex;
in vec4 aColor;
out vec4 vColor;

void main() {
    vColor = aColor;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
