// R46 A piece of paper.
#version 330 core

in vec4 vPaint;
out vec4 fColor;

void main() { fColor = vPaint; }
