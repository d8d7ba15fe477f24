// G8.1 G8.2a G8.2b Shadow map: Phong shading, and the share of a few samples of the shadow map that the light reaches. One
// sample gives a hard edge.
#version 430 core
#include "lighting.glsl"

uniform sampler2DShadow uShadow;
uniform vec3 cameraPosition;
uniform int uGrid = 1;          // samples in each direction
uniform float uWidth = 0.;      // from sample to sample, in texels
uniform bool uDither = false;   // neighbouring pixels share the samples of a grid of half the distance
uniform float uBias = 0.;       // of the depth

in vec3 vPlace, vNormal;
in vec4 vShadow;
out vec4 fColor;

float litShare() {
    vec2 texel = 1. / vec2(textureSize(uShadow, 0));
    vec2 shift = uDither ? uWidth * (mod(floor(gl_FragCoord.xy), 2.) - .5) / 2. : vec2(0.);
    float sum = 0.;
    for (int y = 0; y < uGrid; ++y)
        for (int x = 0; x < uGrid; ++x) {
            vec2 offset = (uWidth * (vec2(x, y) - .5 * float(uGrid - 1)) + shift) * texel;
            // The offset is one of the picture, after the division by w.
            sum += textureProj(uShadow, vShadow + vec4(offset * vShadow.w, -uBias, 0.));
        }
    return sum / float(uGrid * uGrid);
}

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(light.position - vPlace), toEye = normalize(cameraPosition - vPlace);
    vec3 direct = diffuseLight(normal, toLight) + specularLight(normal, toLight, toEye);
    fColor = vec4(ambientLight() + litShare() * direct, 1.);
}
