// R29 Light from above and below, in the direction of the bent normal, times the share of it that arrives.
#version 330 core

uniform float uOcclusion, uBending, uSunlight;

in vec3 vNormal, vBent;
in float vAccess;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal), bent = normalize(mix(normal, vBent, uBending));
    vec3 sky = mix(vec3(.62, .55, .46), vec3(.92, .96, 1.), .5 + .5 * bent.y);
    float sun = max(dot(normal, normalize(vec3(-1., 1.6, 1.))), 0.);
    fColor = vec4(mix(1., vAccess, uOcclusion) * (sky + uSunlight * sun), 1.);
}
