// Panels: noise or turbulence in a square, as grey above and as a graph along the middle line below.
#version 330 core

uniform int uOctaves;
uniform bool uTurbulence;
uniform float uNoiseScale;
uniform float uGain;

in vec2 vST;

out vec4 fColor;

// 0..1, .5 in the middle for noise, 0 at the creases of turbulence.
float valueAt(vec2 place) {
    vec4 octaves = texture(Noise2, uNoiseScale * place) - .5;
    float sum = 0.;
    for (int i = 0; i < uOctaves; ++i) sum += uTurbulence ? abs(octaves[i]) : octaves[i];
    return uTurbulence ? 2. * uGain * sum : .5 + uGain * sum;
}

void main() {
    if (vST.t > .42) {
        fColor = vec4(vec3(valueAt(vec2(vST.s, (vST.t - .42) / .58))), 1.);
        return;
    }
    // The graph: the distance to it in units of its own slope.
    float t = vST.t / .40;
    float value = .08 + .84 * valueAt(vec2(vST.s, .5));
    float slope = (valueAt(vec2(vST.s + .002, .5)) - valueAt(vec2(vST.s - .002, .5))) / .004 * .84;
    float away = abs(t - value) / sqrt(1. + slope * slope * .16);
    vec3 color = mix(vec3(.10, .14, .22), vec3(.16, .22, .34), step(t, value));
    fColor = vec4(mix(vec3(1., .85, .35), color, smoothstep(.015, .04, away)), 1.);
}
