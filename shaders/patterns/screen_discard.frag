// SH004 Screen discard: holes where both texture coordinates are past the wire's width.
#version 330 core

uniform float uDensity;     // the wire's share of a mesh, 0..1
uniform float uFrequency;   // meshes along t; along s twice as many, which makes them square at the equator

in vec4 vColor;
in vec2 vST;

out vec4 fColor;

void main() {
    vec2 inMesh = fract(vST * uFrequency * vec2(2., 1.));
    if (all(greaterThanEqual(inMesh, vec2(uDensity)))) discard;
    float back = gl_FrontFacing ? 1. : .45;
    fColor = vec4(back * vColor.rgb, vColor.a);
}
