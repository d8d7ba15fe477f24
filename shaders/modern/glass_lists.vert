// Transparency lists: normal in eye space.
#version 430 core

uniform mat4 mvp_matrix;
uniform mat3 norm_matrix;

in vec3 vertPos, vertNormal;
out vec3 vNormal;

void main() {
    vNormal = norm_matrix * vertNormal;
    gl_Position = mvp_matrix * vec4(vertPos, 1.);
}
