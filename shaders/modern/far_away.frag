// Light of the sun, white above uSnow, and haze in which what is far away takes the colour of the sky.
#version 330 core

uniform mat4 v_matrix;
uniform vec3 uColor;
uniform float uSnow;

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    float light = .35 + .65 * max(dot(normalize(vNormal), normalize(vec3(-2., 2., 1.))), 0.);
    vec3 color = light * (vPlace.y > uSnow ? vec3(1.) : uColor);
    float distance = length((v_matrix * vec4(vPlace, 1.)).xyz);
    fColor = vec4(mix(vec3(.62, .76, .93), color, exp(-distance / 2e5)), 1.);
}
