// SH066 EX11.7 Cosine interpolation: light and dark of two pictures become lighter and darker in the mixture.
#version 330 core

uniform float uT;       // 0 the first picture alone, 1 the second
uniform sampler2D uBeforeUnit;
uniform sampler2D uAfterUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    const float pi = 3.14159265;
    vec3 before = cos(pi * texture(uBeforeUnit, vST).rgb);
    vec3 after = cos(pi * texture(uAfterUnit, vST).rgb);
    // At uT = .5 this is .5 - .25 cos(pi a) - .25 cos(pi b).
    fColor = vec4(.5 - .5 * mix(before, after, uT), 1.);
}
