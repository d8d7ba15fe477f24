// Indexed vase: place, colour and normal of each vertex go on as the lists have them.
#version 410 core

uniform mat4 m_matrix, vp_matrix;

in vec3 aPlace, aColor, aNormal;
out vec3 vPlace, vColor, vNormal;

void main() {
    vec4 place = m_matrix * vec4(aPlace, 1.);
    vPlace = place.xyz;
    vColor = aColor;
    vNormal = mat3(m_matrix) * aNormal;
    gl_Position = vp_matrix * place;
}
