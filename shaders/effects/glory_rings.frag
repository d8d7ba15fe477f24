// SH121 Glory, its colours: a white middle, then rings that are blue inside and red outside and grow fainter.
#version 330 core

in vec2 vST;

out vec4 fColor;

void main() {
    float v = vST.s;
    // Rings of short waves are narrower: their phase runs faster.
    vec3 phase = 6.2831853 * 3.2 * v * vec3(1., 1.18, 1.38);
    float fade = 1. - smoothstep(.55, .98, v);
    vec3 rings = .55 + .45 * cos(phase) * (1. - .5 * v);
    fColor = vec4(mix(rings, vec3(1.), exp(-40. * v * v)), fade);
}
