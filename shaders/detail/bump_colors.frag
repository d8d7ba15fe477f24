// G10.f9 The picture that belongs to the heights: brass rivets on a dark plate.
#version 410 core

uniform sampler2D uHeights;

in vec2 vST;
out vec4 fColor;

void main() {
    float rivet = smoothstep(.002, .006, texture(uHeights, vST).r);
    fColor = vec4(mix(vec3(.20, .26, .34), vec3(.90, .70, .36), rivet), 1.);
}
