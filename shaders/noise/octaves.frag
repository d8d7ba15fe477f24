// Octaves: the sum of the four octaves of noise with weights of one's own, as a mixture of two colours.
#version 330 core

#include "../common/light.glsl"

uniform vec4 uWeights;     // of the octaves' distances from .5
uniform float uGain;
uniform float uNoiseScale;
uniform vec3 uColor1, uColor2;

in vec3 vModel;
in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 6., 5.);   // eye space

void main() {
    vec4 octaves = texture(Noise3, uNoiseScale * vModel);
    // With the weights 1, 2, 4, 8 this is r + 2 (g - .5) + 4 (b - .5) + 8 (a - .5) + 1.5, whose middle is 2.
    float sum = dot(uWeights, octaves - .5) + 2.;
    vec3 color = mix(uColor1, uColor2, clamp(.5 + uGain * (sum - 2.), 0., 1.));
    fColor = vec4(adsLight(color, normalize(vNormal), vPosition, kLight, 40.), 1.);
}
