// SH051 Chromakey: where the front picture is green the other one is seen, elsewhere a blend of both.
#version 330 core

uniform float uT;       // how far a colour may be from pure green
uniform float uAlpha;   // how much of the front picture is seen where it is not green
uniform sampler2D uBeforeUnit;
uniform sampler2D uAfterUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 before = texture(uBeforeUnit, vST).rgb;
    vec3 after = texture(uAfterUnit, vST).rgb;
    bool green = before.r <= uT && before.g >= 1. - uT && before.b <= uT;
    fColor = vec4(green ? after : mix(after, before, uAlpha), 1.);
}
