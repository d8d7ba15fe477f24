// SH071 EX11.16 Burn-through: the new picture appears in its dark places first.
#version 330 core

uniform float uT;
uniform bool uLuminance;    // dark as the eye sees it, not by the mean of red, green and blue
uniform sampler2D uBeforeUnit;
uniform sampler2D uAfterUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 after = texture(uAfterUnit, vST).rgb;
    float light = dot(after, uLuminance ? vec3(.2125, .7154, .0721) : vec3(1. / 3.));
    fColor = vec4(light < uT ? after : texture(uBeforeUnit, vST).rgb, 1.);
}
