// SH112 Hedgehog: the colour changes from that of the root to that of the tip.
#version 330 core

uniform vec3 uRoot, uTip;

in float gAlong;
in float gLight;

out vec4 fColor;

void main() {
    fColor = vec4(gLight * mix(uRoot, uTip, gAlong), 1.);
}
