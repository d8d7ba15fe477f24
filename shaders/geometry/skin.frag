// SH112 Hedgehog, the skin: diffuse light.
#version 330 core

uniform vec3 uColor;

in vec3 vNormal;

out vec4 fColor;

void main() {
    float light = .3 + .7 * max(dot(normalize(vNormal), normalize(vec3(-.3, .8, .5))), 0.);
    fColor = vec4(light * uColor, 1.);
}
