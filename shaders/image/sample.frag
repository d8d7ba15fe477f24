// SH045 Image: the first picture at uT = 0, the second at 1.
#version 330 core

uniform float uT;
uniform sampler2D uImageUnit;
uniform sampler2D uImage2Unit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 first = texture(uImageUnit, vST).rgb;
    vec3 second = texture(uImage2Unit, vST).rgb;
    fColor = vec4(clamp(mix(first, second, uT), 0., 1.), 1.);
}
