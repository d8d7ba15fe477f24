// For ink drawings: a colour in three tones, and the normal and the distance from which lines are found.
#version 430 core

uniform mat4 v_matrix;
uniform vec3 uColor;

in vec3 vPlace, vNormal;
layout(location = 0) out vec4 fTone;
layout(location = 1) out vec4 fSurface;

void main() {
    vec3 normal = normalize(vNormal);
    float light = max(dot(normal, normalize(vec3(1., 2., 2.))), 0.);
    fTone = vec4((.4 + .2 * floor(3. * light + .5)) * uColor, 1.);
    fSurface = vec4(normal, -(v_matrix * vec4(vPlace, 1.)).z);
}
