// G8.P Planar shadow: the object, projected from the light onto a plane of the world.
#version 430 core

uniform mat4 m_matrix, v_matrix, p_matrix, uFlatten;

in vec3 vertPos;

void main() {
    gl_Position = p_matrix * v_matrix * uFlatten * m_matrix * vec4(vertPos, 1.);
}
