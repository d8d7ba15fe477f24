// A picture on a surface: place and normal in the world, and the texture coordinates.
#version 410 core

uniform mat4 m_matrix, v_matrix, p_matrix, norm_matrix;

in vec3 vertPos, vertNormal;
in vec2 texCoord;
out vec3 vPlace, vNormal;
out vec2 vST;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    vNormal = mat3(norm_matrix) * vertNormal;
    vST = texCoord;
    gl_Position = p_matrix * v_matrix * place;
}
