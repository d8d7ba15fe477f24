// V06 The colour of a uniform variable.
#version 110

uniform vec4 vColor;

void main() {
    gl_FragColor = vColor;
}
