// The picture as it is. Exercise: turn and mirror it.
#version 330 core

uniform int uQuarters;                  // quarter turns, counter-clockwise
uniform bool uLeftRight, uUpDown;       // what changes places
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 st = vST;
    // Change st here. The next line only keeps the uniforms in use.
    if (uQuarters < 0 || (uLeftRight && uUpDown && uQuarters > 4)) st = vec2(0.);
    fColor = vec4(texture(uImageUnit, st).rgb, 1.);
}
