// G14.5n G14.5o G14.5p G14.5q Noise on a cube: white, in blocks, smooth, or the sum of several smooth ones.
#version 410 core
#include "solid_noise.glsl"

uniform int uKind;    // 0 blocks, 1 smooth, 2 turbulence
uniform float uZoom;  // side of a block in units
uniform float uUnits; // units along the cube

in vec3 vNormal, vTexCoord;
out vec4 fColor;

void main() {
    vec3 p = uUnits * clamp(vTexCoord, 0., .9999);
    float grey;
    if (uKind == 0) grey = texelFetch(uWhite, ivec3(p / uZoom) % textureSize(uWhite, 0), 0).r;
    else if (uKind == 1) grey = smoothNoise(p, uZoom);
    else grey = turbulence(p, uZoom) / 256.;
    float light = .55 + .45 * max(dot(normalize(vNormal), normalize(vec3(.5, .8, 1.))), 0.);
    fColor = vec4(vec3(light * grey), 1.);
}
