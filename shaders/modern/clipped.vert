// G14.3 Clipping: as world.vert, with the signed distance from a plane of the model. What is behind the plane is cut off.
#version 430 core

uniform mat4 m_matrix, v_matrix, p_matrix, norm_matrix;
uniform vec4 uPlane;

in vec3 vertPos, vertNormal;
out vec3 vPlace, vNormal;

void main() {
    vec4 place = m_matrix * vec4(vertPos, 1.);
    vPlace = place.xyz;
    vNormal = mat3(norm_matrix) * vertNormal;
    gl_ClipDistance[0] = dot(uPlane, vec4(vertPos, 1.));
    gl_Position = p_matrix * v_matrix * place;
}
