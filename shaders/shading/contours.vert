// Contours: a square raised to a range of hills; the height decides the colour.
#version 330 core

#include "hills.glsl"

out vec2 vXY;         // model space
out vec3 vPosition;   // eye space

void main() {
    vXY = aVertex.xy;
    vec4 raised = vec4(vXY, hills(vXY), 1.);
    vPosition = vec3(uModelViewMatrix * raised);
    gl_Position = uModelViewProjectionMatrix * raised;
}
