// Exercise EX14.2: red presses, blue sucks.
#version 330 core

uniform int uShow;   // 0: needles, 1: isobars, 2: plain

in float vPressure;
in vec3 vNormal;

out vec4 fColor;

void main() {
    float t = clamp(vPressure / (vPressure < 0. ? 3. : 1.), -1., 1.);
    vec3 color = t < 0. ? mix(vec3(.95), vec3(.10, .30, .80), -t) : mix(vec3(.95), vec3(.85, .15, .10), t);
    if (uShow == 1) color *= .8;   // <- dark lines where the pressure is a multiple of 1/2
    float light = .5 + .5 * abs(dot(normalize(vNormal), normalize(vec3(-.3, .6, .7))));
    fColor = vec4(light * color, 1.);
}
