// G8.1 Shadow map: as world.vert, with the place in the shadow map.
#version 430 core

uniform mat4 m_matrix, v_matrix, p_matrix, norm_matrix;
uniform mat4 uShadowMatrix;     // from the model to the picture of the light, mapped to 0..1

in vec3 vertPos, vertNormal;
out vec3 vPlace, vNormal;
out vec4 vShadow;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    vNormal = mat3(norm_matrix) * vertNormal;
    vShadow = uShadowMatrix * vec4(vertPos, 1.);
    gl_Position = p_matrix * v_matrix * place;
}
