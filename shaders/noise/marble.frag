// SH041 Marble: a sine along y, bent by turbulence, mixes stone and vein.
#version 330 core

#include "../common/light.glsl"

uniform vec3 uMarbleColor;
uniform vec3 uVeinColor;
uniform float uNoiseScale;
uniform float uNoiseMag;

in vec3 vModel;
in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 6., 5.);   // eye space

void main() {
    vec4 octaves = abs(texture(Noise3, uNoiseScale * vModel) - .5);
    float turbulence = 4. * (octaves.r + octaves.g + octaves.b + octaves.a);
    float wave = sin(6. * vModel.y + 12. * uNoiseMag * turbulence * .5 + 3. * vModel.x) * .5 + .5;
    vec3 color = mix(uVeinColor, uMarbleColor, pow(wave, .35));
    fColor = vec4(adsLight(color, normalize(vNormal), vPosition, kLight, 60.), 1.);
}
