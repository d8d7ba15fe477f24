// V19 Procedural bumps: in each cell a round dimple, whose normals lean toward its middle, most at its rim.
#version 110
#include "bump_light.glsl"

uniform float bumpDensity, bumpSize;  // bumpSize is the square of a radius
uniform float bumpLean;               // -1: toward the middle

varying vec2 st;
varying vec3 toLight, toEye;

void main() {
    vec2 b = fract(bumpDensity * st) - .5;
    vec3 n = dot(b, b) <= bumpSize ? normalize(vec3(bumpLean * b, 1.)) : vec3(0., 0., 1.);
    gl_FragColor = vec4(bumpLight(n, normalize(toLight), normalize(toEye)), 1.);
}
