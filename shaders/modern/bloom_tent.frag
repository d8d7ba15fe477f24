// A tent of 3 x 3 samples, a texel of uImage apart: the step from one level to the next.
#version 430 core

uniform sampler2D uImage;

in vec2 vST;
out vec4 fColor;

void main() {
    vec2 texel = 1. / vec2(textureSize(uImage, 0));
    vec4 sum = vec4(0.);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            sum += float((2 - abs(x)) * (2 - abs(y))) * texture(uImage, vST + texel * vec2(x, y));
    fColor = sum / 16.;
}
