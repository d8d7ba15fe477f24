// G14.5 Solid texture: as world.vert, with the place in the model as texture coordinates.
#version 430 core

uniform mat4 m_matrix, v_matrix, p_matrix, norm_matrix;
uniform float uSize;        // of the cube of the model that the texture fills
uniform vec3 uCentre = vec3(0.);

in vec3 vertPos, vertNormal;
out vec3 vPlace, vNormal, vTexCoord;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    vNormal = mat3(norm_matrix) * vertNormal;
    vTexCoord = (vertPos - uCentre) / uSize + .5;
    gl_Position = p_matrix * v_matrix * place;
}
