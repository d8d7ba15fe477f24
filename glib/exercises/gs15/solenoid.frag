// Exercise EX15.6: one layer of the flow over the cube -1..1.
#version 330 core

uniform float uDepth;   // 0..1

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 p = 2. * vec3(vST, uDepth) - 1.;
    fColor = vec4(sign(p.z), 0., 0., 1.);   // <- the field at p
}
