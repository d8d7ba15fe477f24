// G9.2 Sky: the place on the cube is the direction of the view.
#version 430 core

uniform mat4 mv_matrix, p_matrix;

in vec3 vertPos;
out vec3 vDirection;

void main() {
    vDirection = vertPos;
    gl_Position = p_matrix * mv_matrix * vec4(vertPos, 1.);
}
