// SH058 Sine warp: coordinates from -1 to 1 plus a sine of themselves, which magnifies the middle or squeezes it.
#version 330 core

uniform float uT;
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 xy = 2. * vST - 1.;
    xy += uT * sin(3.14159265 * xy);
    fColor = vec4(texture(uImageUnit, (xy + 1.) / 2.).rgb, 1.);
}
