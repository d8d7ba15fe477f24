// SH026 ChromaDepth: the colour of the depth, with diffuse light.
#version 330 core

#include "../common/chromadepth.glsl"

uniform float uChromaBlue, uChromaRed;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-3., 6., 4.);   // eye space

void main() {
    float light = .3 + .7 * abs(dot(normalize(vNormal), normalize(kLight - vPosition)));
    fColor = vec4(light * chromaDepth(vPosition.z, uChromaBlue, uChromaRed), 1.);
}
