// G10.4 G10.f15 Height map: a texture moves each vertex along its normal.
#version 430 core

uniform mat4 m_matrix, v_matrix, p_matrix, norm_matrix;
uniform sampler2D heightMap;
uniform float uHeight;

in vec3 vertPos, vertNormal, vertTangent;
in vec2 tc;
out vec3 vPlace, vNormal, vNorth;
out vec2 vST;

void main() {
    vec3 raised = vertPos + uHeight * textureLod(heightMap, tc, 0.).r * vertNormal;
    vec4 place = m_matrix * vec4(raised, 1.);
    vPlace = place.xyz;
    vNormal = mat3(norm_matrix) * vertNormal;
    vNorth = mat3(m_matrix) * vertTangent;
    vST = tc;
    gl_Position = p_matrix * v_matrix * place;
}
