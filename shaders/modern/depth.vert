// G8.1 Depth: positions only.
#version 430 core

uniform mat4 m_matrix, v_matrix, p_matrix;

in vec3 vertPos;

void main() {
    gl_Position = p_matrix * v_matrix * m_matrix * vec4(vertPos, 1.);
}
