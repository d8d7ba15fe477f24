// G15.3b Post: place and normal in world space; only the part on the wanted side of the water is drawn.
#version 430 core

uniform mat4 m_matrix, v_matrix, p_matrix;
uniform float uSide;  // 1 above the water, -1 below it, 0 both

in vec3 vertPos, vertNormal;
out vec3 vPlace, vNormal;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    vNormal = mat3(m_matrix) * vertNormal;
    gl_ClipDistance[0] = uSide * place.y + (uSide == 0. ? 1. : 0.);
    gl_Position = p_matrix * v_matrix * place;
}
