// Deferred shading, first pass: place and normal in world space.
#version 430 core

uniform mat4 m_matrix, v_matrix, p_matrix;

in vec3 vertPos, vertNormal;
out vec3 vPlace, vNormal;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    vNormal = mat3(m_matrix) * vertNormal;
    gl_Position = p_matrix * v_matrix * place;
}
