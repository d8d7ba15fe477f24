// The interpolated light of the vertices (Gouraud). Exercise: light per fragment (Phong).
#version 330 core

uniform bool uGouraud;
uniform vec3 uLight;     // eye space
uniform vec3 uColor;
uniform float uShininess;

in vec3 vPosition;       // eye space
in vec3 vNormal;         // eye space
in vec3 vColor;

out vec4 fColor;

#include "shading/round_light.glsl"

void main() {
    fColor = vec4(vColor, 1.);
    if (!uGouraud) fColor.rgb = vColor;   // Change this.
}
