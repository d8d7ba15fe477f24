// EX16.11 Circle squared on a teapot: its texture coordinates, and its normals for the light.
#version 330 core

out vec2 vST;
out vec3 vPosition;
out vec3 vNormal;

void main() {
    vST = aTexCoord0.st;
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
