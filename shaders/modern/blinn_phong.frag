// G7.3 Blinn-Phong shading: as Phong shading, with the half vector.
#version 430 core
#include "lighting.glsl"

uniform vec3 cameraPosition;

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(light.position - vPlace), toEye = normalize(cameraPosition - vPlace);
    vec3 color = ambientLight() + diffuseLight(normal, toLight) + blinnLight(normal, toLight, toEye);
    fColor = vec4(color, 1.);
}
