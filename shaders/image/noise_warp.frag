// SH060 Noise warp: each place shows the picture a little beside it, and two looks into the noise say where.
#version 330 core

uniform float uT;       // about the largest shift, in tenths of the picture
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

float noise(vec3 place) {
    return dot(texture(Noise3, place), vec4(1.)) - 2.;
}

void main() {
    vec2 shift = vec2(noise(vec3(vST, .1)), noise(vec3(vST.ts + .37, .6)));
    fColor = vec4(texture(uImageUnit, vST + uT * shift).rgb, 1.);
}
