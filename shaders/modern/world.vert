// G7.2 World space: place and normal for lighting per fragment.
#version 430 core

uniform mat4 m_matrix, v_matrix, p_matrix, norm_matrix;

in vec3 vertPos, vertNormal;
out vec3 vPlace, vNormal;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    vNormal = mat3(norm_matrix) * vertNormal;
    gl_Position = p_matrix * v_matrix * place;
}
