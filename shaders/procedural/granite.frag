// R41 Granite: fine noise makes grains; the absolute value of a signed sum makes them black, grey and white with sharp borders.
#version 330 core

uniform float uNoiseScale;      // as fine as grains are small
uniform float uContrast;
uniform vec3 uStone;

in vec3 vPlace;
in vec3 vNormal;

out vec4 fColor;

void main() {
    vec4 octaves = texture(Noise3, uNoiseScale * vPlace) - .5;
    float grains = clamp(uContrast * abs(dot(octaves, vec4(1., 1.5, 2., 2.))), 0., 1.);
    // A second, coarser look adds pale feldspar.
    float feldspar = smoothstep(.53, .58, texture(Noise3, .37 * uNoiseScale * vPlace.yzx).g);
    vec3 color = mix(uStone * grains, vec3(.86, .76, .7), .7 * feldspar);
    vec3 normal = normalize(vNormal);
    float light = .35 + .65 * max(dot(normal, normalize(vec3(.4, .6, 1.))), 0.);
    float gloss = .25 * pow(max(dot(normal, normalize(vec3(.2, .3, 1.))), 0.), 60.);
    fColor = vec4(color * light + gloss, 1.);
}
