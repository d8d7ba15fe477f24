// G7.2 Phong shading: the normal is interpolated, and the light is computed per fragment.
#version 430 core
#include "lighting.glsl"

uniform vec3 cameraPosition;

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(light.position - vPlace), toEye = normalize(cameraPosition - vPlace);
    vec3 color = ambientLight() + diffuseLight(normal, toLight) + specularLight(normal, toLight, toEye);
    fColor = vec4(color, 1.);
}
