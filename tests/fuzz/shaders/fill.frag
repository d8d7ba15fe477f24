//@ fragment 384
#version 430
in vec2 vST;
out vec4 fColor;
readonly buffer Palette { vec4 colors[]; };
void main() { fColor = colors[int(vST.x * 8.)]; }
