// One colour.
#version 150

uniform vec3 uColor;

out vec4 fColor;

void main() { fColor = vec4(uColor, 1.); }
