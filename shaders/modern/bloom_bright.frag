// What is brighter than a threshold.
#version 430 core

uniform sampler2D uImage;
uniform float uThreshold;

in vec2 vST;
out vec4 fColor;

void main() {
    fColor = vec4(max(texture(uImage, vST).rgb - uThreshold, 0.), 1.);
}
