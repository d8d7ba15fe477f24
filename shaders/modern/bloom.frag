// The picture with its bloom, brought into 0..1.
#version 430 core

uniform sampler2D uImage, uBloom;
uniform float uStrength, uExposure;

in vec2 vST;
out vec4 fColor;

void main() {
    vec3 light = texture(uImage, vST).rgb + uStrength * textureLod(uBloom, vST, 0.).rgb;
    fColor = vec4(1. - exp(-uExposure * light), 1.);
}
