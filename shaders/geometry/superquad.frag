// EX12.2 Superquad: the mixed colour, lit, with thin lines between the cells.
#version 330 core

#include "../common/light.glsl"

in vec3 gColor;
in vec3 gNormal;
in vec3 gPosition;
in vec2 gCell;

out vec4 fColor;

void main() {
    vec2 toLine = abs(fract(gCell + .5) - .5) / fwidth(gCell);
    float line = 1. - smoothstep(.6, 1.6, min(toLine.x, toLine.y));
    vec3 lit = adsLight(gColor, normalize(gNormal), gPosition, vec3(-3., 5., 3.), 30.);
    fColor = vec4(mix(lit, vec3(.05), .7 * line), 1.);
}
