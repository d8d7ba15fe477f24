// Deferred shading, first pass: what the light will need, into three targets.
#version 430 core

uniform vec4 uColor;

in vec3 vPlace, vNormal;
layout(location = 0) out vec4 fPlace;
layout(location = 1) out vec4 fNormal;
layout(location = 2) out vec4 fColor;

void main() {
    fPlace = vec4(vPlace, 1.);
    fNormal = vec4(normalize(vNormal), 0.);
    fColor = uColor;
}
