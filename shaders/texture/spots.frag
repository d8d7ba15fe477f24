// D01 First pass: elliptical spots with outlines that noise displaces.
#version 330 core

uniform float uAd, uBd;
uniform float uNoiseAmp, uNoiseFreq;
uniform float uTol;

in vec2 vST;
in vec3 vModel;
in vec3 vColor;

out vec4 fColor;

const vec3 kSpot = vec3(.55, .06, .10);

void main() {
    vec2 cell = vec2(uAd, uBd);
    vec2 fromCentre = vST - (floor(vST / cell) + .5) * cell;
    vec4 octaves = texture(Noise3, uNoiseFreq * vModel);
    float shake = uNoiseAmp * .5 * (octaves.r + octaves.g + octaves.b + octaves.a - 2.);
    float distance = length(fromCentre);
    if (distance > 0.) fromCentre *= (distance + shake) / distance;
    vec2 scaled = fromCentre / (.5 * cell);
    float edge = max(uTol, 1e-4);
    float ground = smoothstep(1. - edge, 1. + edge, dot(scaled, scaled));
    float brightness = max(vColor.r, max(vColor.g, vColor.b));
    fColor = vec4(mix(kSpot * brightness, vColor, ground), 1.);
}
