// G8.n Two shadows: place and normal in the world, texture coordinates, and the places in both shadow maps.
#version 410 core

uniform mat4 m_matrix, v_matrix, p_matrix, norm_matrix, uToLamp, uToSun;

in vec3 vertPos, vertNormal;
in vec2 texCoord;
out vec3 vPlace, vNormal;
out vec2 vST;
out vec4 vLamp, vSun;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    vNormal = mat3(norm_matrix) * vertNormal;
    vST = texCoord;
    vLamp = uToLamp * vec4(vertPos, 1.);
    vSun = uToSun * vec4(vertPos, 1.);
    gl_Position = p_matrix * v_matrix * place;
}
