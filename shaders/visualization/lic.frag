// SH109 Line integral convolution: the mean of 2 uLength + 1 samples of noise, one texel apart, along the streamline
// through the fragment. The flow is sampled at every step.
#version 330 core

uniform sampler2D uImageUnit;
uniform sampler2D uFlowUnit;   // a unit vector in red and green
uniform int uLength;
uniform vec3 uColor;

in vec2 vST;

out vec4 fColor;

vec2 flow(vec2 st) {
    vec2 v = texture(uFlowUnit, clamp(st, .008, .992)).rg;
    float size = length(v);
    return size > 1e-4 ? v / size : vec2(0.);
}

// The sum of the samples on one side. Midpoint steps follow round streamlines.
float walk(float direction) {
    vec2 st = vST;
    float texel = direction / float(textureSize(uImageUnit, 0).s);
    float sum = 0.;
    for (int i = 0; i < uLength; ++i) {
        st += texel * flow(st + .5 * texel * flow(st));
        sum += texture(uImageUnit, clamp(st, 0., 1.)).r;
    }
    return sum;
}

void main() {
    float sum = texture(uImageUnit, vST).r + walk(1.) + walk(-1.);
    float mean = sum / float(2 * uLength + 1);
    float contrast = sqrt(float(uLength + 1));   // the mean of n samples varies less, by 1 / sqrt(n)
    float grey = clamp(.5 + .6 * contrast * (mean - .5), 0., 1.);
    fColor = vec4(grey < .5 ? 2. * grey * uColor : mix(uColor, vec3(1.), 2. * grey - 1.), 1.);
}
