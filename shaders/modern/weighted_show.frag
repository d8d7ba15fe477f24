// The weighted mean of all glass over what is behind it.
#version 430 core

uniform sampler2D uBehind, uSum, uThrough;

in vec2 vST;
out vec4 fColor;

void main() {
    vec4 sum = texture(uSum, vST);
    vec3 glass = sum.rgb / max(sum.a, 1e-5);
    fColor = vec4(mix(glass, texture(uBehind, vST).rgb, texture(uThrough, vST).r), 1.);
}
