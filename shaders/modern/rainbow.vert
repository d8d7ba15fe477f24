// G4.1b Rainbow cube: the colour is the place in the model, mapped from -1..1 to 0..1.
#version 430 core

uniform mat4 mv_matrix, p_matrix;
uniform vec3 uCentre = vec3(0.);    // of the model

in vec3 vertPos;
out vec3 vColor;

void main() {
    vColor = .5 * (vertPos - uCentre) + .5;
    gl_Position = p_matrix * mv_matrix * vec4(vertPos, 1.);
}
