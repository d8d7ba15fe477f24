// G7.1 Gouraud shading: the light is computed at the vertices and interpolated.
#version 430 core
#include "lighting.glsl"

uniform mat4 m_matrix, v_matrix, p_matrix, norm_matrix;
uniform vec3 cameraPosition;

in vec3 vertPos, vertNormal;
out vec3 vColor;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vec3 normal = normalize(mat3(norm_matrix) * vertNormal);
    vec3 toLight = normalize(light.position - place.xyz), toEye = normalize(cameraPosition - place.xyz);
    vColor = ambientLight() + diffuseLight(normal, toLight) + specularLight(normal, toLight, toEye);
    gl_Position = p_matrix * v_matrix * place;
}
