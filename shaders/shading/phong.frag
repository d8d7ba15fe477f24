// SH023 Phong shading: ambient, diffuse and specular light with the interpolated normal.
#version 330 core

#include "../common/light.glsl"

uniform vec3 uColor;
uniform float uShininess;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 5., 6.);   // eye space

void main() {
    fColor = vec4(adsLight(uColor, normalize(vNormal), vPosition, kLight, uShininess), 1.);
}
