// EX16.16 Lit explosion: a round point, lit by the normal that it carries.
#version 330 core

#include "../common/light.glsl"

uniform bool uLit;

in vec3 gColor;
in vec3 gNormal;
in vec3 gPosition;

out vec4 fColor;

void main() {
    vec2 p = 2. * gl_PointCoord - 1.;
    if (dot(p, p) > 1.) discard;
    vec3 lit = adsLight(gColor, normalize(gNormal), gPosition, vec3(-4., 6., 6.), 30.);
    fColor = vec4(uLit ? lit : gColor, 1.);
}
