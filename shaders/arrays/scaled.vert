// V13 Pulsating sphere: the sine of the time scales the model before the matrices. Below 0 it is mirrored.
#version 110

uniform mat4 mvpMatrix;
uniform float timeLapsed;  // milliseconds

attribute vec4 vPosition;

void main() {
    gl_Position = mvpMatrix * vec4(sin(.001 * timeLapsed) * vPosition.xyz, 1.);
}
