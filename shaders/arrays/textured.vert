// V17 V18 Texture coordinates, and the place on the model.
#version 110

uniform mat4 mvpMatrix;

attribute vec4 vPosition;
attribute vec2 texCoord;
varying vec2 st;
varying vec3 place;

void main() {
    st = texCoord;
    place = vPosition.xyz;
    gl_Position = mvpMatrix * vPosition;
}
