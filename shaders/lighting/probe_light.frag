// R26 A surface lit by a photograph of its surroundings: the diffuse map at its normal, the glossy one at the mirrored view.
#version 330 core
#include "../common/direction.glsl"

uniform sampler2D uDiffuseMap, uGlossyMap, uSharpMap;
uniform mat4 inverseView;
uniform float uGloss;          // share of the mirrored light
uniform bool uSharp;
uniform vec3 uColor;
uniform float uExposure;

in vec3 vPosition;
in vec3 vNormal;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal), ray = normalize(vPosition);
    vec3 n = mat3(inverseView) * normal, mirrored = mat3(inverseView) * reflect(ray, normal);
    vec3 diffuse = textureLod(uDiffuseMap, placeOf(n), 0.).rgb;
    vec3 glossy = textureLod(uGlossyMap, placeOf(mirrored), 0.).rgb;
    if (uSharp) glossy = textureLod(uSharpMap, placeOf(mirrored), 0.).rgb;
    float fresnel = uGloss + (1. - uGloss) * .5 * pow(1. - max(dot(normal, -ray), 0.), 5.);
    vec3 light = uExposure * mix(uColor * diffuse, glossy, fresnel);
    fColor = vec4(sqrt(light / (1. + .35 * light)), 1.);
}
