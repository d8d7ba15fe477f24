// Start, the pass: place and normal in world space, for lighting per fragment.
#version 430 core

uniform mat4 m_matrix, norm_matrix, mvp_matrix;

in vec3 vertPos, vertNormal;
out vec3 vPlace, vNormal;

void main() {
    vPlace = (m_matrix * vec4(vertPos, 1.)).xyz;
    vNormal = mat3(norm_matrix) * vertNormal;
    gl_Position = mvp_matrix * vec4(vertPos, 1.);
}
