// Round bumps: light from the interpolated normal (Phong), or the interpolated light of the vertices (Gouraud).
#version 330 core

uniform bool uGouraud;
uniform vec3 uLight;     // eye space
uniform vec3 uColor;
uniform float uShininess;

in vec3 vPosition;
in vec3 vNormal;
in vec3 vColor;

out vec4 fColor;

#include "round_light.glsl"

void main() {
    vec3 phong = roundLight(uColor, normalize(vNormal), vPosition, uLight, uShininess);
    fColor = vec4(uGouraud ? vColor : phong, 1.);
}
