// G10.1 Bumps: the place in the world, and place and normal in the model, on which the bumps sit.
#version 410 core

uniform mat4 m_matrix, v_matrix, p_matrix;

in vec3 vertPos, vertNormal;
out vec3 vPlace, vModelPlace, vModelNormal;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    vModelPlace = vertPos;
    vModelNormal = vertNormal;
    gl_Position = p_matrix * v_matrix * place;
}
