// SH004 Screen discard: a hole where both texture coordinates lie beyond the width of the wire.
#version 330 core

uniform float uDensity;     // share of a mesh that is wire, 0..1
uniform float uFrequency;   // meshes along t; along s there are twice as many, so that they are square at the equator

in vec4 vColor;
in vec2 vST;

out vec4 fColor;

void main() {
    vec2 inMesh = fract(vST * uFrequency * vec2(2., 1.));
    if (all(greaterThanEqual(inMesh, vec2(uDensity)))) discard;
    float back = gl_FrontFacing ? 1. : .45;
    fColor = vec4(back * vColor.rgb, vColor.a);
}
