// SH110 LIC on a box: the mean of 2 uLength + 1 samples of noise along the streamline; where the flow is slower than uTol it is not followed.
#version 330 core

uniform sampler3D uImageUnit;
uniform sampler3D uFlowUnit;
uniform int uLength;
uniform float uScale;   // texels in a step
uniform float uTol;
uniform vec3 uColor;

in vec3 vSTP;
in vec3 vNormal;

out vec4 fColor;

vec3 flow(vec3 stp) {
    vec3 v = texture(uFlowUnit, stp).xyz;
    float speed = length(v);
    return speed > max(uTol, 1e-6) ? v / speed : vec3(0.);
}

float walk(float direction) {
    vec3 stp = vSTP;
    float h = direction * uScale / float(textureSize(uImageUnit, 0).s);
    float sum = 0.;
    for (int i = 0; i < uLength; ++i) {
        stp += h * flow(stp + .5 * h * flow(stp));
        sum += texture(uImageUnit, stp).r;
    }
    return sum;
}

void main() {
    float sum = texture(uImageUnit, vSTP).r + walk(1.) + walk(-1.);
    float mean = sum / float(2 * uLength + 1);
    float grey = clamp(.5 + .55 * sqrt(1. + .5 * float(uLength)) * (mean - .5), 0., 1.);
    vec3 color = grey < .5 ? 2. * grey * uColor : mix(uColor, vec3(1.), 2. * grey - 1.);
    float light = .55 + .45 * max(dot(normalize(vNormal), normalize(vec3(-.3, .8, .6))), 0.);
    fColor = vec4(light * color, 1.);
}
