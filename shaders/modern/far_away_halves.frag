// One picture left of uSplit, the other one right of it.
#version 330 core

uniform sampler2D uLeft, uRight;
uniform float uSplit;

in vec2 vST;
out vec4 fColor;

void main() {
    bool isLine = abs(vST.s - uSplit) < .002 && uSplit > 0. && uSplit < 1.;
    fColor = isLine ? vec4(1.) : vST.s < uSplit ? texture(uLeft, vST) : texture(uRight, vST);
}
