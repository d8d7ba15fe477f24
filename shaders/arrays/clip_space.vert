// V06 The places are those of clip space, so there are no matrices.
#version 110

attribute vec4 vPosition;

void main() {
    gl_Position = vPosition;
}
