// S03 The interpolated colour.
#version 110

void main() { gl_FragColor = gl_Color; }
