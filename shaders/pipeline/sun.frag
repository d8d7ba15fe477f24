// Gx6.1 The surface of a sun: bright grains and dark spots of noise on the directions of a ball.
#version 410 core
#include "../modern/noise.glsl"

in vec2 vST;
out vec4 fColor;

void main() {
    float longitude = 6.2831853 * vST.s, latitude = 3.14159265 * (vST.t - .5);
    vec3 p = vec3(-cos(longitude) * cos(latitude), sin(latitude), sin(longitude) * cos(latitude));
    float grain = fractalNoise(6. * p, 4), spots = fractalNoise(1.7 * p + 9., 3);
    vec3 color = mix(vec3(.93, .42, .06), vec3(1., .92, .55), smoothstep(-.6, .6, grain));
    fColor = vec4(mix(color, vec3(.45, .13, .02), smoothstep(.38, .6, spots)), 1.);
}
