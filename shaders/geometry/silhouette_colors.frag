// EX12.1 Coloured silhouettes: the colour of the edge.
#version 330 core

in vec3 gColor;

out vec4 fColor;

void main() {
    fColor = vec4(gColor, 1.);
}
