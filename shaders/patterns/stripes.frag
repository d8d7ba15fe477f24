// SH029 Stripes: a smooth pulse of half-width uP in the middle of every period 1 / uA.
#version 330 core

uniform float uA, uP, uTol;
uniform vec3 uStripeColor;

in float vX;
in vec4 vColor;
in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 6., 5.);   // eye space

void main() {
    float f = fract(uA * vX);
    float edge = max(uTol, 1e-4);
    float stripe = smoothstep(.5 - uP - edge, .5 - uP + edge, f) - smoothstep(.5 + uP - edge, .5 + uP + edge, f);

    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(kLight - vPosition);
    float light = .3 + .7 * abs(dot(normal, toLight));
    float shine = .35 * pow(max(dot(reflect(-toLight, normal), normalize(-vPosition)), 0.), 40.);
    fColor = vec4(light * mix(vColor.rgb, uStripeColor, stripe) + shine, vColor.a);
}
