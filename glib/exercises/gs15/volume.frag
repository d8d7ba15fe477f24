// Exercises EX15.2 to EX15.5: a volume, composited front to back.
#version 330 core

#include "common/rainbow.glsl"

uniform sampler3D uField;
uniform int uNumSteps;   // along the diagonal of the volume
uniform float uMin;      // smaller values are transparent
uniform float uAmax;     // opacity of one of 100 steps at the value 100

in vec3 vModel;
in vec3 vSight;

out vec4 fColor;

void main() {
    vec3 step = normalize(vSight) * sqrt(3.) / float(max(uNumSteps, 1));
    vec3 stp = (vModel + 1.) / 2. + .5 * step;
    vec3 color = vec3(0.);
    float left = 1.;   // the share of light that is not yet absorbed
    for (int i = 0; i < uNumSteps; ++i, stp += step) {
        if (any(lessThan(stp, vec3(0.))) || any(greaterThan(stp, vec3(1.)))) break;
        float value = texture(uField, stp).r;
        if (value < uMin) continue;
        // <- quantise the value, or leave it out; the colour may be lit
        float opacity = clamp(uAmax * (value - uMin) / max(100. - uMin, 1.), 0., .999);
        float alpha = 1. - pow(1. - opacity, 100. / float(uNumSteps));   // the same for any number of steps
        color += left * alpha * rainbow(value / 100.);
        left *= 1. - alpha;
        if (left < .003) break;
    }
    if (left > .999) discard;
    fColor = vec4(color / (1. - left), 1. - left);
}
