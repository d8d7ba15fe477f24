// Gx15.1 Gx15.2 Something above or below the water: place and normal in the world, and the place in the model for its stripes.
#version 410 core

uniform mat4 m_matrix, vp_matrix, norm_matrix;

in vec3 vertPos, vertNormal;
out vec3 vPlace, vNormal, vModelPlace;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    vNormal = mat3(norm_matrix) * vertNormal;
    vModelPlace = vertPos;
    gl_Position = vp_matrix * place;
}
