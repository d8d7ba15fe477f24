// EX11.19 Octaves: the first octave of the noise as red, the second as green, the third as blue.
#version 330 core

uniform float uGain;        // 1 shows the values as they are, which is nearly grey

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 octaves = texture(Noise3, vec3(vST, .2)).rgb - .5;
    // Each octave is half as strong as the one before; here all are equally strong.
    fColor = vec4(clamp(.5 + uGain * octaves * mix(vec3(1.), vec3(1., 2., 4.), clamp(uGain - 1., 0., 1.)), 0., 1.), 1.);
}
