// G5.1 Texture: the colour of the picture.
#version 430 core

uniform sampler2D uImage;

in vec2 vTexCoord;
out vec4 fColor;

void main() {
    fColor = vec4(texture(uImage, vTexCoord).rgb, 1.);
}
