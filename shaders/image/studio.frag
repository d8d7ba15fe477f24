// A lit body for the studio's green screen.
#version 330 core

uniform vec3 uColor;

in vec3 vNormal;

out vec4 fColor;

void main() {
    float light = .3 + .7 * max(dot(normalize(vNormal), normalize(vec3(.5, .7, 1.))), 0.);
    fColor = vec4(uColor * light, 1.);
}
