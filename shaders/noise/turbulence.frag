// SH039 Turbulence: the sum of the octaves, or of their distances from the middle, mixes two colours.
#version 330 core

#include "../common/light.glsl"

uniform bool uTurbulence;
uniform float uNoiseScale;
uniform float uNoiseMag;
uniform vec3 uColor1, uColor2;

in vec3 vModel;
in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 6., 5.);   // eye space

void main() {
    vec4 octaves = texture(Noise3, uNoiseScale * vModel) - .5;
    float t = uTurbulence ? dot(abs(octaves), vec4(uNoiseMag)) : .5 + dot(octaves, vec4(uNoiseMag)) * .5;
    vec3 color = mix(uColor1, uColor2, clamp(t, 0., 1.));
    fColor = vec4(adsLight(color, normalize(vNormal), vPosition, kLight, 40.), 1.);
}
