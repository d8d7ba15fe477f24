// G14.2m Shows a texture in the whole target.
#version 430 core

uniform sampler2D uImage;

in vec2 vST;
out vec4 fColor;

void main() {
    fColor = vec4(texture(uImage, vST).rgb, 1.);
}
