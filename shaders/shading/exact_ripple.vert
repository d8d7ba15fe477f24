// SH024 Exact shading: raises the grid. The fragments get the place on the surface, not the normal.
#version 330 core

uniform float uHeight;

out vec2 vXY;         // model space
out vec3 vPosition;   // eye space

void main() {
    vXY = aVertex.xy;
    vec4 raised = vec4(vXY, uHeight * sin(dot(vXY, vXY)), 1.);
    vPosition = vec3(uModelViewMatrix * raised);
    gl_Position = uModelViewProjectionMatrix * raised;
}
