// D01 OvalNoise: one ellipse in every cell uAd x uBd of the texture square; noise changes its radius.
#version 330 core

#include "../common/chromadepth.glsl"

uniform float uAd, uBd;                // width and height of a cell, which the ellipse fills
uniform float uNoiseAmp, uNoiseFreq;
uniform float uAlpha;                  // alpha of the ground between the spots; 0 discards it
uniform float uTol;                    // half the width of the spots' soft edge
uniform bool uUseChromaDepth;
uniform float uChromaBlue, uChromaRed; // eye-space z of the farthest and the nearest colour
uniform vec3 uDotColor;

in vec2 vST;
in vec3 vModel;
in vec3 vPosition;
in vec3 vNormal;
in vec4 vColor;

out vec4 fColor;

const vec3 kLight = vec3(-3., 5., 5.);   // eye space

void main() {
    vec2 cell = vec2(uAd, uBd);
    vec2 fromCentre = vST - (floor(vST / cell) + .5) * cell;

    // The noise is added to the distance from the centre; the direction stays.
    vec4 octaves = texture(Noise3, uNoiseFreq * vModel);
    float shake = uNoiseAmp * .5 * (octaves.r + octaves.g + octaves.b + octaves.a - 2.);
    float distance = length(fromCentre);
    if (distance > 0.) fromCentre *= (distance + shake) / distance;

    vec2 scaled = fromCentre / (.5 * cell);
    float edge = max(uTol, 1e-4);
    float ground = smoothstep(1. - edge, 1. + edge, dot(scaled, scaled));

    vec4 base = vec4(vColor.rgb, uAlpha);
    vec4 color = mix(vec4(uDotColor, 1.), base, ground);
    if (color.a < .004) discard;
    if (uUseChromaDepth) color.rgb = mix(chromaDepth(vPosition.z, uChromaBlue, uChromaRed), color.rgb, .5 * ground);

    float light = .3 + .7 * abs(dot(normalize(vNormal), normalize(kLight - vPosition)));
    fColor = vec4(light * color.rgb, color.a);
}
