// EX13.5 Two spheres: white is the mean size, red twice as large, blue half and less.
#version 400 core

in float gSize;
in vec3 gNormal;

out vec4 fColor;

void main() {
    float t = clamp(gSize, -1.5, 1.5) / 1.5;
    vec3 color = t > 0. ? mix(vec3(.95, .94, .88), vec3(.95, .30, .15), t) : mix(vec3(.95, .94, .88), vec3(.12, .35, .85), -t);
    float light = .35 + .65 * max(dot(normalize(gNormal), normalize(vec3(-.4, .6, .8))), 0.);
    fColor = vec4(light * color, 1.);
}
