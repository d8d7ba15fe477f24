// G15.3b Post: red and white bands.
#version 430 core

uniform vec3 uSun;

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    vec3 color = fract(vPlace.y / 2.) < .5 ? vec3(.85, .12, .08) : vec3(.95);
    fColor = vec4((.35 + .65 * max(dot(normalize(vNormal), normalize(uSun)), 0.)) * color, 1.);
}
