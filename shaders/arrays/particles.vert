// V15 Particle cloud: the sine of the time scales the places, so that the cloud breathes.
#version 110

uniform mat4 mvpMatrix;
uniform float timeLapsed;  // milliseconds

attribute vec3 particle, particleColor;
varying vec3 color;

void main() {
    color = particleColor;
    gl_Position = mvpMatrix * vec4(sin(timeLapsed / 5000.) * particle, 1.);
}
