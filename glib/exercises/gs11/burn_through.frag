// The new picture where the mean of its colours is dark. Exercise: by luminance, if uLuminance is true.
#version 330 core

uniform float uT;
uniform bool uLuminance;
uniform sampler2D uBeforeUnit;
uniform sampler2D uAfterUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 after = texture(uAfterUnit, vST).rgb;
    float light = dot(after, vec3(1. / 3.));
    if (uLuminance) light = after.g;    // Green alone. Change this line.
    fColor = vec4(light < uT ? after : texture(uBeforeUnit, vST).rgb, 1.);
}
