// R54 What the light needs in eye space; for outlines the surface is moved out along its normal.
#version 330 core

uniform bool uIsEdge;
uniform float uOutline;

out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space

void main() {
    vNormal = uNormalMatrix * aNormal;
    vPosition = vec3(uModelViewMatrix * aVertex) + (uIsEdge ? uOutline : 0.) * normalize(vNormal);
    gl_Position = uProjectionMatrix * vec4(vPosition, 1.);
}
