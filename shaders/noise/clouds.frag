// SH042 Clouds: noise with three times its lowest octave goes through a cosine and mixes sky and cloud.
#version 330 core

#include "../common/light.glsl"

uniform vec3 uSkyColor;
uniform vec3 uCloudColor;
uniform float uBias;
uniform float uGain;   // spreads the noise texture's narrow range over the cosine
uniform float uNoiseScale;
uniform bool uLit;

in vec3 vModel;
in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 6., 5.);   // eye space

void main() {
    vec4 octaves = texture(Noise3, uNoiseScale * vModel + vec3(.17, .31, .53));
    float noise = (3. * octaves.r + octaves.g + octaves.b + octaves.a - 3.) * .5;   // about 0
    float x = clamp(.5 - uGain * noise, 0., 1.);
    float t = clamp((1. + cos(3.14159265 * x)) / 2. + uBias, 0., 1.);
    vec3 color = mix(uSkyColor, uCloudColor, t);
    if (uLit) color = adsLight(color, normalize(vNormal), vPosition, kLight, 60.);
    fColor = vec4(color, 1.);
}
