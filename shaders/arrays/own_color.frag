// V03 Pass through: the interpolated colour.
#version 110

void main() {
    gl_FragColor = gl_Color;
}
