// A disc over the picture. Exercise: make it a lens.
#version 330 core

uniform float uEta;         // index of refraction
uniform float uRadius;      // in widths of the picture
uniform vec2 uCentre;
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 d = vST - uCentre;
    vec2 st = vST;
    vec3 color = texture(uImageUnit, st).rgb;
    // Inside the radius, move st before the colour is looked up.
    if (length(d) < uRadius) color *= 1. - .1 * uEta;
    fColor = vec4(color, 1.);
}
