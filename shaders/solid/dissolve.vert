// Gx14.6 Dissolve: coordinates for a picture, and the place in the model for noise.
#version 410 core

uniform mat4 mv_matrix, p_matrix;
uniform float uUnits;  // units of noise along one unit of the model

in vec3 vertPos;
in vec2 texCoord;
out vec2 vTexCoord;
out vec3 vNoisePlace;

void main() {
    vTexCoord = texCoord;
    vNoisePlace = uUnits * (vertPos + 4.);
    gl_Position = p_matrix * mv_matrix * vec4(vertPos, 1.);
}
