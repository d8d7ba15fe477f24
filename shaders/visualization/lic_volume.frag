// EX15.7 LIC as a volume: threads glow in the colour of their speed, composited front to back.
#version 330 core

#include "../common/rainbow.glsl"

uniform sampler3D uThreads;
uniform sampler3D uFlowUnit;
uniform int uNumSteps;     // along the diagonal of the volume
uniform float uOpacity;

in vec3 vModel;
in vec3 vSight;

out vec4 fColor;

void main() {
    vec3 step = normalize(vSight) * sqrt(3.) / float(max(uNumSteps, 1));
    vec3 stp = (vModel + 1.) / 2. + .5 * step;
    vec3 color = vec3(0.);
    float left = 1.;
    for (int i = 0; i < uNumSteps; ++i, stp += step) {
        if (any(lessThan(stp, vec3(0.))) || any(greaterThan(stp, vec3(1.)))) break;
        float thread = smoothstep(.012, .06, texture(uThreads, stp).r);
        if (thread <= 0.) continue;
        float alpha = 1. - pow(1. - .95 * uOpacity * thread, 100. / float(uNumSteps));
        float speed = length(texture(uFlowUnit, stp).xyz);
        color += left * alpha * (.35 + .65 * thread) * rainbow(pow(speed / 2., .4));
        left *= 1. - alpha;
        if (left < .003) break;
    }
    if (left > .999) discard;
    fColor = vec4(color / (1. - left), 1. - left);
}
