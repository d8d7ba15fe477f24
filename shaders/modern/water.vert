// G15.1 G15.3c Planes of water and floor: place in world space.
#version 430 core

uniform mat4 m_matrix, v_matrix, p_matrix;

in vec3 vertPos;
out vec3 vPlace;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    gl_Position = p_matrix * v_matrix * place;
}
