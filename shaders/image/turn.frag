// SH057 Turn: the picture turned by quarters of a circle, then mirrored.
#version 330 core

uniform int uQuarters;                  // quarter turns, counter-clockwise
uniform bool uLeftRight, uUpDown;       // what changes places
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 st = vST;
    if (uLeftRight) st.s = 1. - st.s;
    if (uUpDown) st.t = 1. - st.t;
    for (int quarter = 0; quarter < uQuarters; quarter++) st = vec2(st.t, 1. - st.s);
    fColor = vec4(texture(uImageUnit, st).rgb, 1.);
}
