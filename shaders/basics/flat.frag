// Flat colours: each pixel has the colour of the corner that decides.
#version 330 core

flat in vec4 vColor;

out vec4 fColor;

void main() {
    fColor = vColor;
}
