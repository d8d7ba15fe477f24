// What draws geometry that has no program: the position by the model-view-projection, the colour as it is.
#version 410 core

uniform mat4 uModelViewProjectionMatrix;
in vec4 aVertex;
in vec4 aColor;
out vec4 vColor;

void main() {
    vColor = aColor;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
