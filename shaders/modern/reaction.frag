// The second substance as light on dark.
#version 430 core

uniform sampler2D uSubstances;

in vec2 vST;
out vec4 fColor;

void main() {
    float share = smoothstep(.05, .35, texture(uSubstances, vST).g);
    fColor = vec4(mix(vec3(.05, .05, .2), vec3(1., .85, .5), share), 1.);
}
