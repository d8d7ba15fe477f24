// The picture, and the light of its bright parts spread around them.
#version 330 core

uniform sampler2D uPicture;
uniform float uReach;   // in parts of the picture

in vec2 vST;
out vec4 fColor;

void main() {
    vec3 glow = vec3(0.);
    for (int i = 0; i < 64; i++) {
        float angle = 2.4 * float(i), away = uReach * sqrt(float(i) / 64.);
        vec3 there = texture(uPicture, vST + away * vec2(cos(angle), sin(angle))).rgb;
        glow += max(there - .4, 0.) / 64.;
    }
    fColor = vec4(texture(uPicture, vST).rgb + 1.5 * glow, 1.);
}
