// G15.1 Sky: the place on the box around the eye is the direction.
#version 430 core

uniform mat4 mvp_matrix;

in vec3 vertPos;
out vec3 vDirection;

void main() {
    vDirection = vertPos;
    gl_Position = mvp_matrix * vec4(vertPos, 1.);
}
