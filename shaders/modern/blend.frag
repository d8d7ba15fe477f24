// G14.2m Blending: a colour whose alpha grows from bottom to top, in a cell of a table.
#version 430 core

uniform vec4 uBottom, uTop;

in vec2 vST;
out vec4 fColor;

void main() {
    fColor = mix(uBottom, uTop, vST.y);
}
