// EX14.2 Pressure: red presses, blue sucks; isobars at every half unit.
#version 330 core

uniform int uShow;   // needles, isobars, plain

in float vPressure;
in vec3 vNormal;

out vec4 fColor;

void main() {
    float t = clamp(vPressure / (vPressure < 0. ? 3. : 1.), -1., 1.);
    vec3 color = t < 0. ? mix(vec3(.95), vec3(.10, .30, .80), -t) : mix(vec3(.95), vec3(.85, .15, .10), t);
    if (uShow == 1) {
        float away = abs(2. * vPressure - floor(2. * vPressure + .5)) / max(fwidth(2. * vPressure), 1e-5);
        color *= mix(.3, 1., smoothstep(.5, 1.5, away));
    }
    float light = .5 + .5 * abs(dot(normalize(vNormal), normalize(vec3(-.3, .6, .7))));
    fColor = vec4(light * color, 1.);
}
