// G12.2 Bezier sheet: the control points of the patch come from a uniform array, without vertex data.
#version 430 core

uniform vec3 uPoints[16];

void main() {
    gl_Position = vec4(uPoints[gl_VertexID], 1.);
}
