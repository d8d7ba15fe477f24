// EX15.7 LIC as a volume, one layer of it: the mean of 2 uLength + 1 samples of the noise along the streamline.
#version 330 core

uniform sampler3D uImageUnit;
uniform sampler3D uFlowUnit;
uniform int uLength;
uniform float uDepth;

in vec2 vST;

out vec4 fColor;

vec3 flow(vec3 stp) {
    vec3 v = texture(uFlowUnit, stp).xyz;
    float speed = length(v);
    return speed > 1e-4 ? v / speed : vec3(0.);
}

void main() {
    vec3 start = vec3(vST, uDepth);
    float sum = texture(uImageUnit, start).r;
    for (float direction = -1.; direction < 2.; direction += 2.) {
        vec3 stp = start;
        float h = direction / 64.;
        for (int i = 0; i < uLength; ++i) {
            stp += h * flow(stp + .5 * h * flow(stp));
            sum += texture(uImageUnit, stp).r;
        }
    }
    fColor = vec4(min(sum / float(2 * uLength + 1), 1.));
}
