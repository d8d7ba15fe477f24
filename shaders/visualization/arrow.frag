// SH111 Streamtube arrow: lit per fragment.
#version 330 core

#include "../common/light.glsl"

uniform vec3 uColor;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 7., 5.);   // eye space

void main() {
    fColor = vec4(adsLight(uColor, normalize(vNormal), vPosition, kLight, 50.), 1.);
}
