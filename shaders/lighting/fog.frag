// R11 Fog in four forms: linear, exponential, exponential with the square, and depth cueing, which is linear fog toward black.
#version 330 core

uniform int uForm;                // 0 linear, 1 exp, 2 exp2, 3 depth cueing
uniform float uStart, uEnd, uDensity;
uniform vec3 uFog, uColor;
uniform bool uLit;

in float vDistance;
in vec3 vNormal;
out vec4 fColor;

void main() {
    float depth = uDensity * vDistance;
    float clear = uForm == 1 ? exp(-depth) : uForm == 2 ? exp(-depth * depth) : (uEnd - vDistance) / (uEnd - uStart);
    float light = uLit ? .35 + .65 * max(dot(normalize(vNormal), normalize(vec3(-1., 2., 1.))), 0.) : 1.;
    fColor = vec4(mix(uForm == 3 ? vec3(0.) : uFog, light * uColor, clamp(clear, 0., 1.)), 1.);
}
