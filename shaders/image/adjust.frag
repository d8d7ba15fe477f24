// SH061 SH062 SH063 SH064 Adjustments: mixes with the negative, with black, with middle grey, and with the luminance.
#version 330 core

uniform sampler2D uImageUnit;
uniform float uNegative, uBrightness, uContrast, uSaturation;

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 color = texture(uImageUnit, vST).rgb;
    color = mix(color, 1. - color, uNegative);
    color = mix(vec3(0.), color, uBrightness);
    color = mix(vec3(.5), color, uContrast);
    color = mix(vec3(dot(color, vec3(.2125, .7154, .0721))), color, uSaturation);
    fColor = vec4(clamp(color, 0., 1.), 1.);
}
