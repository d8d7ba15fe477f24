// V20 Bumps from a normal map, whose colours 0..1 mean -1..1.
#version 110
#include "bump_light.glsl"

uniform sampler2D normalMap;

varying vec2 st;
varying vec3 toLight, toEye;

void main() {
    vec3 n = normalize(2. * texture2D(normalMap, st).rgb - 1.);
    gl_FragColor = vec4(bumpLight(n, normalize(toLight), normalize(toEye)), 1.);
}
