// SH102 Probe: the field at the eye-space position of the fragment, with a little light to show the shape.
#version 330 core

#include "../common/rainbow.glsl"

uniform sampler3D uTexUnit;
uniform float uMin, uMax;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kFieldCentre = vec3(0., 0., -3.4);   // eye space; the box of the field is 2 wide

void main() {
    vec3 stp = clamp((vPosition - kFieldCentre + 1.) / 2., 0., 1.);
    float value = texture(uTexUnit, stp).r;
    if (value < uMin || value > uMax) discard;
    float light = .55 + .45 * abs(dot(normalize(vNormal), normalize(vec3(-.4, .6, .7))));
    fColor = vec4(light * rainbow(value / 100.), 1.);
}
