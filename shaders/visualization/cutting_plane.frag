// SH099 SH100 Cutting plane: the field in colours, darkened within uTol of every multiple of ten.
#version 330 core

#include "../common/rainbow.glsl"

uniform sampler3D uTexUnit;
uniform float uMin, uMax;
uniform float uTol;   // half the width of a contour, in units of the field; 0 for none

in vec3 vModel;

out vec4 fColor;

void main() {
    vec3 stp = (vModel + 1.) / 2.;
    if (any(lessThan(stp, vec3(0.))) || any(greaterThan(stp, vec3(1.)))) discard;   // outside the field
    float value = texture(uTexUnit, stp).r;
    if (value < uMin || value > uMax) discard;
    float toContour = abs(value - 10. * floor(value / 10. + .5));   // floor, so that negative values work in the same way
    float wide = .5 * fwidth(value);   // the contour fades out within a pixel
    float line = mix(.35, 1., smoothstep(uTol - wide, uTol + wide + 1e-6, toContour));
    fColor = vec4(line * rainbow(value / 100.), 1.);
}
