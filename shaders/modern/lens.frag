// G17.3 Lens: reads the picture of an eye nearer to its middle, the more the farther out; outside of it is black.
#version 430 core

uniform sampler2D uView;
uniform float uK1, uK2, uZoom;

in vec2 vST;
out vec4 fColor;

void main() {
    vec2 fromMiddle = uZoom * (vST - .5);
    float r2 = dot(fromMiddle, fromMiddle);
    fColor = texture(uView, fromMiddle / (1. + uK1 * r2 + uK2 * r2 * r2) + .5);
}
