// EX11.18 Control noise: the number from 0 to 1 that decides when each place changes, as grey.
#version 330 core

in vec2 vST;

out vec4 fColor;

void main() {
    vec4 octaves = texture(Noise3, vec3(2. * vST - 1., .2) / 2.);
    fColor = vec4(vec3(fract((octaves.r + octaves.g + octaves.b + octaves.a - 1.) / 2.)), 1.);
}
