// G10.1 Bumps: each component of the normal is changed by a sine of the same component of the place; then Phong's light.
#version 410 core
#include "../modern/lighting.glsl"

uniform mat4 norm_matrix;
uniform vec3 cameraPosition;
uniform float uHeight, uFrequency;

in vec3 vPlace, vModelPlace, vModelNormal;
out vec4 fColor;

void main() {
    vec3 bumped = normalize(vModelNormal) + uHeight * sin(uFrequency * vModelPlace);
    vec3 normal = normalize(mat3(norm_matrix) * bumped);
    vec3 toLight = normalize(light.position - vPlace), toEye = normalize(cameraPosition - vPlace);
    vec3 color = ambientLight() + diffuseLight(normal, toLight) + specularLight(normal, toLight, toEye);
    fColor = vec4(color, 1.);
}
