// Indexed meshes: places in the world, moved as a whole; the normals of the mesh.
#version 410 core

uniform mat4 m_matrix, vp_matrix;

in vec3 aPlace, aNormal, aShift;
out vec3 vPlace, vNormal;

void main() {
    vec4 place = m_matrix * vec4(aPlace, 1.) + vec4(aShift, 0.);
    vPlace = place.xyz;
    vNormal = aNormal;
    gl_Position = vp_matrix * place;
}
