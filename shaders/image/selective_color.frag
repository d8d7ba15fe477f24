// EX11.6 Selective colouring: only the colours near one hue stay, all others become grey.
#version 330 core
#include "hue.glsl"

uniform float uHue, uWidth;     // degrees
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 color = texture(uImageUnit, vST).rgb;
    vec3 hsv = toHsv(color);
    float away = 360. * hueDistance(hsv.x, uHue / 360.);
    float kept = (1. - smoothstep(uWidth - 5., uWidth + 5., away)) * smoothstep(.1, .3, hsv.y);
    fColor = vec4(mix(vec3(dot(color, vec3(.2125, .7154, .0721))), color, kept), 1.);
}
