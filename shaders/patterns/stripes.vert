// SH016 Stripes: x in model space or in eye space.
#version 330 core

uniform bool uUseModelCoords;

out float vX;
out vec4 vColor;
out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space

void main() {
    vPosition = vec3(uModelViewMatrix * aVertex);
    vX = uUseModelCoords ? aVertex.x : vPosition.x;
    vNormal = uNormalMatrix * aNormal;
    vColor = aColor;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
