// G11.f7 G11.f10 A colour for each level of division.
#version 410 core

flat in int vLevel;
out vec4 fColor;

const vec3 kColors[7] = vec3[](vec3(.95, .95, .9), vec3(.95, .40, .35), vec3(.96, .70, .25), vec3(.60, .82, .35),
                               vec3(.30, .78, .72), vec3(.38, .58, .95), vec3(.72, .48, .92));

void main() {
    fColor = vec4(kColors[clamp(vLevel, 0, 6)], 1.);
}
