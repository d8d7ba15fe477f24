// G13.1b G13.4 World space: place and normal of each corner, for a geometry stage or for Phong shading.
#version 430 core

uniform mat4 m_matrix, v_matrix, p_matrix, norm_matrix;

in vec3 vertPos, vertNormal;
out Corner {
    vec3 place, normal;
} corner;

void main() {
    corner.place = vec3(m_matrix * vec4(vertPos, 1.));
    corner.normal = mat3(norm_matrix) * vertNormal;
    gl_Position = p_matrix * v_matrix * vec4(corner.place, 1.);
}
