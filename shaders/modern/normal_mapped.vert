// G10.2 G10.3 Normal mapping: place and axes of the surface in world space. The tangent points north.
#version 430 core

uniform mat4 m_matrix, v_matrix, p_matrix, norm_matrix;

in vec3 vertPos, vertNormal, vertTangent;
in vec2 tc;
out vec3 vPlace, vNormal, vNorth;
out vec2 vST;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    vNormal = mat3(norm_matrix) * vertNormal;
    vNorth = mat3(m_matrix) * vertTangent;
    vST = tc;
    gl_Position = p_matrix * v_matrix * place;
}
