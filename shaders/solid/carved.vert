// Solid textures: place and normal in the world, and the place in the model as the coordinate of the texture.
#version 410 core

uniform mat4 m_matrix, v_matrix, p_matrix, norm_matrix;
uniform mat4 texRot_matrix = mat4(1.);  // turns the texture in the model
uniform float uSize;                    // of the cube of the model that the texture fills
uniform vec3 uCentre = vec3(0.);

in vec3 vertPos, vertNormal;
out vec3 vPlace, vNormal, vTexCoord;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    vNormal = mat3(norm_matrix) * vertNormal;
    vTexCoord = mat3(texRot_matrix) * ((vertPos - uCentre) / uSize) + .5;
    gl_Position = p_matrix * v_matrix * place;
}
