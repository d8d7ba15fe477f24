// S14 The interpolated colour.
#version 120

void main() { gl_FragColor = gl_Color; }
