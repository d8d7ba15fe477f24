// G12.5b How much the ground has moved between two moments: red up, blue down.
#version 410 core

uniform sampler2DArray uGround;  // before and after for each spacing
uniform int uSpacing;
uniform float uGain;

in vec2 vST;
out vec4 fColor;

void main() {
    float change = uGain * (texture(uGround, vec3(vST, 2 * uSpacing + 1)).r - texture(uGround, vec3(vST, 2 * uSpacing)).r);
    fColor = vec4(vec3(.95) - max(change, 0.) * vec3(0., 1., 1.) - max(-change, 0.) * vec3(1., 1., 0.), 1.);
}
