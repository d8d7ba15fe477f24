// Light from a lamp that shines in all directions: a cube map holds how far it reaches.
#version 430 core

uniform samplerCube uReach;
uniform vec3 uLamp, uColor;

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    vec3 toLamp = uLamp - vPlace;
    float lit = texture(uReach, -toLamp).r + .05 < length(toLamp) ? 0. : 1.;
    float diffuse = max(dot(normalize(vNormal), normalize(toLamp)), 0.);
    fColor = vec4((.1 + 1.5 * lit * diffuse / (1. + .15 * dot(toLamp, toLamp))) * uColor, 1.);
}
