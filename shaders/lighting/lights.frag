// R10 A bowl: the sphere below a height, inside with the light of its back or, with one side, that of its front.
#version 330 core

uniform bool uTwoSided;
uniform float uRim;

in vec3 vFront, vBack;
in float vHeight;
out vec4 fColor;

void main() {
    if (vHeight > uRim) discard;
    fColor = vec4(uTwoSided && !gl_FrontFacing ? vBack : vFront, 1.);
}
