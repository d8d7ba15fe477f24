// Gx3.3 Quaternions: a mesh turned to an attitude between two others.
#version 410 core
#include "quaternions.glsl"

uniform mat4 m_matrix, v_matrix, p_matrix;
uniform vec3 uTo;       // yaw, pitch and roll in radians
uniform float uT;
uniform bool uSlerp;
uniform vec3 uPlace;

in vec3 vertPos, vertNormal;
out vec3 vNormal;

void main() {
    vec4 q = attitude(uTo, uT, uSlerp);
    vNormal = turned(q, mat3(m_matrix) * vertNormal);
    vec3 place = uPlace + turned(q, vec3(m_matrix * vec4(vertPos, 1.)));
    gl_Position = p_matrix * v_matrix * vec4(place, 1.);
}
