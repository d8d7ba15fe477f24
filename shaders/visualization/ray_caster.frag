// SH104 Volume ray casting: C += a* alpha c, a* *= 1 - alpha, step by step, until little light is left.
#version 330 core

#include "../common/rainbow.glsl"

uniform sampler3D uTexUnit;
uniform int uNumSteps;       // along the diagonal of the volume
uniform float uMin, uMax;    // values outside are transparent
uniform float uAmax;         // opacity of one step where the value is uMax

in vec3 vModel;
in vec3 vSight;

out vec4 fColor;

void main() {
    // In texture space the volume is the unit cube, with a diagonal of sqrt(3).
    vec3 step = normalize(vSight) * sqrt(3.) / float(max(uNumSteps, 1));
    vec3 stp = (vModel + 1.) / 2. + .5 * step;
    vec3 color = vec3(0.);
    float left = 1.;   // the share of light that is not yet absorbed
    for (int i = 0; i < uNumSteps; ++i, stp += step) {
        if (any(lessThan(stp, vec3(0.))) || any(greaterThan(stp, vec3(1.)))) break;
        float value = texture(uTexUnit, stp).r;
        if (value < uMin || value > uMax) continue;
        float alpha = uAmax * (uMax > uMin ? (value - uMin) / (uMax - uMin) : 1.);
        color += left * alpha * rainbow(value / 100.);
        left *= 1. - alpha;
        if (left < .001) break;
    }
    if (left > .999) discard;   // this includes the far faces, where the ray leaves at once
    fColor = vec4(color / (1. - left), 1. - left);
}
