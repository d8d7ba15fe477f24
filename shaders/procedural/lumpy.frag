// R43 Vertex noise: a lit clay, light on hills and dark in valleys.
#version 330 core

uniform float uHeight;
uniform vec3 uHill, uValley;

in vec3 vNormal;
in float vHeight;

out vec4 fColor;

void main() {
    float light = .25 + .75 * max(dot(normalize(vNormal), normalize(vec3(.5, .7, .8))), 0.);
    float share = uHeight > 0. ? clamp(.5 + 2.2 * vHeight / uHeight, 0., 1.) : .5;
    fColor = vec4(mix(uValley, uHill, share) * light, 1.);
}
