// Gx14.6 Dissolve: a place goes when the threshold passes its noise: white, turbulence, or turbulence with hard edges.
#version 410 core
#include "solid_noise.glsl"

uniform sampler2D uPicture;
uniform float uThreshold, uZoom, uSharpness;
uniform int uKind;

in vec2 vTexCoord;
in vec3 vNoisePlace;
out vec4 fColor;

void main() {
    float noise;
    if (uKind == 0) noise = texelFetch(uWhite, ivec3(vNoisePlace) % textureSize(uWhite, 0), 0).r;
    else noise = turbulence(vNoisePlace, uZoom) / 256.;
    if (uKind == 2) noise = logistic(256. * (noise - .5), uSharpness);
    if (noise <= uThreshold) discard;
    vec3 color = texture(uPicture, vTexCoord).rgb;
    // The rim that goes next glows.
    fColor = vec4(uKind == 0 ? color : mix(vec3(1., .6, .1), color, smoothstep(0., .03, noise - uThreshold)), 1.);
}
