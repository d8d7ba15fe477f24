// The axes of --axes: lines in the space before the view, a colour a line.
#version 410 core

uniform mat4 uMatrix;
in vec3 aPosition;
in vec3 aColor;
out vec3 vColor;

void main() {
    vColor = aColor;
    gl_Position = uMatrix * vec4(aPosition, 1.0);
}
