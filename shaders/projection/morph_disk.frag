// SH125 Morph: the map of the planet, with diffuse light.
#version 330 core

uniform sampler2D uPlanetUnit;

in vec2 vST;
in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 5., 8.);   // eye space

void main() {
    float light = .25 + .85 * abs(dot(normalize(vNormal), normalize(kLight - vPosition)));
    fColor = vec4(light * texture(uPlanetUnit, vST).rgb, 1.);
}
