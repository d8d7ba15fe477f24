// G2.2c Point of two colours: red to the left of a column of the window, blue to its right.
#version 430 core

uniform float uSplit;   // in pixels

out vec4 fColor;

void main() {
    fColor = gl_FragCoord.x < uSplit ? vec4(1., 0., 0., 1.) : vec4(0., 0., 1., 1.);
}
