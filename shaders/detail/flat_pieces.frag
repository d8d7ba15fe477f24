// G11.f10 Flat pieces of a surface: the colour tells how often they were divided, the shade how they lie.
#version 410 core

uniform bool uLines;

flat in int vLevel;
flat in vec3 vFace;
out vec4 fColor;

const vec3 kColors[7] = vec3[](vec3(.80, .80, .76), vec3(.95, .40, .35), vec3(.96, .70, .25), vec3(.60, .82, .35),
                               vec3(.30, .78, .72), vec3(.38, .58, .95), vec3(.72, .48, .92));

void main() {
    float light = .35 + .65 * abs(dot(vFace, normalize(vec3(1., 2.5, 1.5))));
    fColor = vec4(uLines ? vec3(.05, .06, .08) : light * kColors[clamp(vLevel, 0, 6)], 1.);
}
