// SH043 Wood: rings around the y axis, displaced by noise. Each ring goes from light to dark and back.
#version 330 core

#include "../common/light.glsl"

uniform vec3 uLightWoodColor;
uniform vec3 uDarkWoodColor;
uniform float uRingFreq;
uniform float uNoiseScale;
uniform float uNoiseMag;

in vec3 vModel;
in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 6., 5.);   // eye space

void main() {
    vec4 octaves = texture(Noise3, uNoiseScale * vModel);
    vec3 moved = vModel + uNoiseMag * (octaves.rgb - .5);
    float ring = fract(length(moved.xz) * uRingFreq + octaves.r + octaves.g + octaves.b);
    float t = ring < .75 ? ring / .75 : (1. - ring) / .25;   // slow growth, then a sharp edge

    float fibre = texture(Noise3, vec3(8. * moved.xz, .35 * moved.y).xzy).r;   // fine lines along the trunk
    vec3 color = mix(uLightWoodColor, uDarkWoodColor, clamp(.15 + .75 * t * t + 1.1 * (fibre - .5), 0., 1.));
    fColor = vec4(adsLight(color, normalize(vNormal), vPosition, kLight, 25.), 1.);
}
