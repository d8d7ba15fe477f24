// SH040 Erosion: only fragments whose noise lies between uMin and uMax are kept.
#version 330 core

#include "../common/light.glsl"

uniform float uMin, uMax;
uniform float uNoiseScale;
uniform vec3 uColor;

in vec3 vModel;
in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 6., 5.);   // eye space

void main() {
    vec4 octaves = texture(Noise3, uNoiseScale * vModel);
    float noise = (octaves.r + octaves.g + octaves.b + octaves.a - 1.) / 2.;
    if (noise < uMin || noise > uMax) discard;

    float rust = smoothstep(0., .02, min(noise - uMin, uMax - noise));   // darker along the eroded edges
    vec3 color = uColor * (gl_FrontFacing ? mix(.45, 1., rust) : .45);
    fColor = vec4(adsLight(color, normalize(vNormal), vPosition, kLight, 30.), 1.);
}
