// Gx17.2 Cube dust: each face in its own light, fading into the dark.
#version 410 core

uniform vec3 viewPos;

flat in vec3 vColor;
in vec3 vPlace;
out vec4 fColor;

void main() {
    vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
    float light = .35 + .65 * max(dot(normal, normalize(vec3(.3, .8, .5))), 0.);
    fColor = vec4(light * exp(-.003 * distance(viewPos, vPlace)) * 1.6 * vColor, 1.);
}
