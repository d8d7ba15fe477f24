// EX16.11 Circle squared on a teapot: s and t are cut into texels, whose numbers take the place of the pixels.
#version 330 core

#include "../common/light.glsl"

uniform int uTexels;   // along s and t
uniform float uSide;

in vec2 vST;
in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

void main() {
    vec2 xy = uSide * (floor(clamp(vST, 0., .9999) * float(uTexels)) + .5);
    int c = int(dot(xy, xy) + .25);   // .25 is far from both roundings
    float hue = float(c % 360) / 359.;
    vec3 bright = clamp(abs(fract(hue + vec3(0., 2. / 3., 1. / 3.)) * 6. - 3.) - 1., 0., 1.);
    vec3 color = (c & 1) == 1 ? vec3(.08) : .15 + .8 * bright;
    fColor = vec4(adsLight(color, normalize(vNormal), vPosition, vec3(-4., 6., 5.), 40.), 1.);
}
