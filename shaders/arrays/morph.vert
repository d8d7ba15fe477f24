// V16 Morph: each vertex has a place in a first and in a second outline, and moves from one to the other.
#version 110

uniform mat4 mvpMatrix;
uniform float timeStep;  // 0: the first outline, 1: the second

attribute vec2 first, second;

void main() {
    vec2 place = mix(first, second, timeStep) + 8. * timeStep;
    gl_Position = mvpMatrix * vec4(place, 0., 1.);
}
