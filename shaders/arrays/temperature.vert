// V07 A temperature per vertex becomes a number from 0 (cold) to 1 (hot).
#version 110

uniform float tempRange;

attribute vec4 vPosition;
attribute float vertexTemp;
varying float temperature;

void main() {
    temperature = vertexTemp / tempRange;
    gl_Position = vPosition;
}
