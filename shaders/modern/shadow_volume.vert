// G8.V Shadow volume: the place in the world, from which the geometry stage goes on.
#version 430 core

uniform mat4 m_matrix;

in vec3 vertPos;

void main() {
    gl_Position = m_matrix * vec4(vertPos, 1.);
}
