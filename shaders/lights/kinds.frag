// G7.A G7.B G7.C G7.D One of four kinds of light on a matt surface, all of it in the world.
#version 410 core

uniform int uKind;              // 0 ambient, 1 directional, 2 positional, 3 spot
uniform vec3 uMaterial;
uniform vec3 uLight;            // colour
uniform vec3 uPlace;            // of the lamp
uniform vec3 uDirection;        // of the light, where it goes
uniform vec3 uAttenuation;      // constant, linear, quadratic
uniform float uCutoff, uExponent;   // of the spot: degrees, and how fast it fades toward its edge

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal), fromLamp = vPlace - uPlace;
    float d = length(fromLamp), strength = 1.;
    if (uKind == 1) strength = max(dot(normal, -normalize(uDirection)), 0.);
    if (uKind >= 2) strength = max(dot(normal, -fromLamp) / d, 0.) / dot(uAttenuation, vec3(1., d, d * d));
    if (uKind == 3) {
        float cosine = dot(fromLamp / d, normalize(uDirection));
        strength *= cosine > cos(radians(uCutoff)) ? pow(cosine, uExponent) : 0.;
    }
    fColor = vec4(strength * uLight * uMaterial, 1.);
}
