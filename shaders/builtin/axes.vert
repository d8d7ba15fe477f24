// The vertex stage of the axes that --axes draws. aPosition is in the space before the view transformation.
#version 410 core

uniform mat4 uMatrix;
in vec3 aPosition;

void main() {
    gl_Position = uMatrix * vec4(aPosition, 1.0);
}
