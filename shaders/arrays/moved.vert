// V08 V09 One matrix takes places of the model to the picture.
#version 110

uniform mat4 mvpMatrix;

attribute vec4 vPosition;

void main() {
    gl_Position = mvpMatrix * vPosition;
}
