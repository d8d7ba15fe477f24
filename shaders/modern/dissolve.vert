// G14.9 Dissolve: coordinates for a picture, and for noise in three dimensions.
#version 430 core

uniform mat4 mv_matrix, p_matrix;
uniform float uSize;    // of the cube of the model that the noise fills

in vec3 vertPos;
in vec2 texCoord;
out vec2 vTexCoord;
out vec3 vNoiseCoord;

void main() {
    vTexCoord = texCoord;
    vNoiseCoord = vertPos / uSize + .5;
    gl_Position = p_matrix * mv_matrix * vec4(vertPos, 1.);
}
