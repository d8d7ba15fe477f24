// SH069 Horizontal replace: the new picture pushes the old one to the right until it is gone.
#version 330 core

uniform float uT;
uniform sampler2D uBeforeUnit;
uniform sampler2D uAfterUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    // Neither quotient is 0/0: s < uT needs uT > 0, and the other case uT < 1 because s is below 1.
    bool after = vST.s < uT;
    vec2 st = after ? vec2(vST.s / uT, vST.t) : vec2((vST.s - uT) / (1. - uT), vST.t);
    fColor = vec4(after ? textureLod(uAfterUnit, st, 0.).rgb : textureLod(uBeforeUnit, st, 0.).rgb, 1.);
}
