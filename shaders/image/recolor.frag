// EX11.8 Recolour: a key by hue finds one object, and its hue is shifted.
#version 330 core
#include "hue.glsl"

uniform float uKey, uWidth, uShift;     // degrees
uniform float uSaturation;              // less saturated places are no part of the object
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 color = texture(uImageUnit, vST).rgb;
    vec3 hsv = toHsv(color);
    if (360. * hueDistance(hsv.x, uKey / 360.) < uWidth && hsv.y > uSaturation) {
        hsv.x = fract(hsv.x + uShift / 360.);
        color = toRgb(hsv);
    }
    fColor = vec4(color, 1.);
}
