// G16.2 Shows a picture that a compute shader has made.
#version 430 core

uniform sampler2D uPicture;

in vec2 vST;
out vec4 fColor;

void main() {
    fColor = texture(uPicture, vST);
}
