// G14.5a Marble map: diagonal bands, which turbulence bends.
#version 410 core
#include "solid_noise.glsl"

uniform float uVeins, uPower, uZoom;

in vec3 vNormal, vTexCoord;
out vec4 fColor;

void main() {
    float phase = vTexCoord.x + vTexCoord.y + vTexCoord.z + uPower * turbulence(256. * vTexCoord, uZoom) / 256.;
    float grey = abs(sin(3.14159265 * uVeins * phase));
    float light = .6 + .4 * max(dot(normalize(vNormal), normalize(vec3(.5, .8, 1.))), 0.);
    fColor = vec4(vec3(light * grey), 1.);
}
