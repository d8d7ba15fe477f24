// G14.7 Clouds: the texture coordinates of the dome, and a slice of the noise.
#version 430 core

uniform mat4 mv_matrix, p_matrix;
uniform float uSlice;

in vec3 vertPos;
in vec2 texCoord;
out vec3 vTexCoord;

void main() {
    vTexCoord = vec3(texCoord, uSlice);
    gl_Position = p_matrix * mv_matrix * vec4(vertPos, 1.);
}
