// Exact shading of another surface: raises the grid; fragments get the place, not the normal.
#version 330 core

#include "exact_surface.glsl"

uniform int uSurface;
uniform float uHeight;

out vec2 vXY;
out vec3 vPosition;   // eye space

void main() {
    vXY = aVertex.xy;
    vec4 raised = vec4(vXY, surface(uSurface, vXY, uHeight).x, 1.);
    vPosition = vec3(uModelViewMatrix * raised);
    gl_Position = uModelViewProjectionMatrix * raised;
}
