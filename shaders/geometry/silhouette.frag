// SH077 Silhouettes: the colour of the lines.
#version 330 core

uniform vec3 uInk;

out vec4 fColor;

void main() {
    fColor = vec4(uInk, 1.);
}
