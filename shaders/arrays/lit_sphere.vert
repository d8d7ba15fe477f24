// V12 Lit sphere: on a sphere around the origin, a place is its own normal. All is done in the space of the model, so the
// light turns with it.
#version 110

uniform mat4 mvpMatrix;

attribute vec4 vPosition;
varying vec3 place;

void main() {
    place = vPosition.xyz;
    gl_Position = mvpMatrix * vPosition;
}
