// EX15.6 LIC in three dimensions: one layer of the solenoid field over the cube -1..1.
#version 330 core

uniform float uDepth;   // 0..1
uniform int uField;     // as printed, symmetric

in vec2 vST;

out vec4 fColor;

void main() {
    vec3 p = 2. * vec3(vST, uDepth) - 1., q = p * p;
    float first = uField == 0 ? q.x + q.y : q.y + q.z;
    fColor = vec4(p.y * p.z * first, p.x * p.z * (q.x + q.z), p.x * p.y * (q.x + q.y), 1.);
}
