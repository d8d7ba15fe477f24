// EX11.17 Pattern transition: the new picture appears where a third picture is darker than uT.
#version 330 core

uniform float uT;
uniform float uSoft;        // width of the edge, in brightness of the pattern
uniform sampler2D uBeforeUnit, uAfterUnit, uPatternUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    float pattern = texture(uPatternUnit, vST).r;
    // The edge starts below 0 and ends above 1, so that the ends show one picture alone.
    float after = clamp((uT * (1. + uSoft) - pattern) / uSoft, 0., 1.);
    fColor = vec4(mix(texture(uBeforeUnit, vST).rgb, texture(uAfterUnit, vST).rgb, after), 1.);
}
