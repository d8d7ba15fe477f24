// D22 Volume in five ways: composited front to back, with values quantised, picked by a tolerance, or lit by the gradient.
#version 330 core

#include "../common/rainbow.glsl"

uniform sampler3D uField;
uniform int uShow;       // smooth, quantised, tolerance, lit, lit with tolerance
uniform int uNumSteps;   // along the diagonal of the volume
uniform float uMin;      // smaller values are transparent
uniform float uAmax;     // opacity of one of 100 steps at the value 100
uniform int uClasses;
uniform float uSpacing;
uniform float uTol;      // half the width, in units of the field

in vec3 vModel;
in vec3 vSight;

out vec4 fColor;

vec3 gradient(vec3 stp) {
    vec2 h = vec2(1. / 32., 0.);
    return vec3(texture(uField, stp + h.xyy).r - texture(uField, stp - h.xyy).r,
                texture(uField, stp + h.yxy).r - texture(uField, stp - h.yxy).r,
                texture(uField, stp + h.yyx).r - texture(uField, stp - h.yyx).r);
}

void main() {
    vec3 step = normalize(vSight) * sqrt(3.) / float(max(uNumSteps, 1));
    vec3 stp = (vModel + 1.) / 2. + .5 * step;
    vec3 toLight = normalize(vec3(-.5, .7, .6)), toEye = -normalize(mat3(uModelViewMatrix) * vSight);
    vec3 color = vec3(0.);
    float left = 1.;   // the share of light that is not yet absorbed
    bool pick = uShow == 2 || uShow == 4, lit = uShow >= 3;
    for (int i = 0; i < uNumSteps; ++i, stp += step) {
        if (any(lessThan(stp, vec3(0.))) || any(greaterThan(stp, vec3(1.)))) break;
        float value = texture(uField, stp).r;
        if (value < uMin) continue;
        float weight = 1.;
        if (uShow == 1) {
            float size = 100. / float(uClasses);
            value = min((floor(value / size) + .5) * size, 100. - .5 * size);   // the middle of its class
        }
        if (pick) weight = 1. - smoothstep(.6 * uTol, uTol, abs(value - uSpacing * floor(value / uSpacing + .5)));
        if (weight <= 0.) continue;
        float opacity = clamp(uAmax * weight * (pick ? 2.5 : (value - uMin) / max(100. - uMin, 1.)), 0., .999);
        float alpha = 1. - pow(1. - opacity, 100. / float(uNumSteps));   // the same for any number of steps
        vec3 here = rainbow(value / 100.);
        if (lit) {
            vec3 g = uNormalMatrix * gradient(stp);
            float size = length(g);
            vec3 normal = size > 1e-4 ? -g / size : toEye;
            if (dot(normal, toEye) < 0.) normal = -normal;
            float shine = pow(max(dot(reflect(-toLight, normal), toEye), 0.), 30.);
            here = (.15 + .85 * max(dot(normal, toLight), 0.)) * here + .5 * shine;
        }
        color += left * alpha * here;
        left *= 1. - alpha;
        if (left < .003) break;
    }
    if (left > .999) discard;   // this includes the far faces, where the ray leaves at once
    fColor = vec4(color / (1. - left), 1. - left);
}
