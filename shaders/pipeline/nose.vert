// Gx3.3 Quaternions: the way of a plane's nose, as points at equal times.
#version 410 core
#include "quaternions.glsl"

uniform mat4 v_matrix, p_matrix;
uniform vec3 uTo;       // yaw, pitch and roll in radians
uniform bool uSlerp;
uniform vec3 uPlace;
uniform int uCount;     // points

void main() {
    float t = float(gl_VertexID) / float(uCount - 1);
    vec3 place = uPlace + turned(attitude(uTo, t, uSlerp), vec3(0., 0., -1.25));
    gl_Position = p_matrix * v_matrix * vec4(place, 1.);
}
