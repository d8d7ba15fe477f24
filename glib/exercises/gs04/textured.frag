// The texture coordinates as colours. Exercise: a picture.
#version 330 core

in vec2 vST;

out vec4 fColor;

void main() {
    fColor = vec4(vST, 0., 1.);    // Change this.
}
