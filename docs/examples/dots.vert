// Dots: normals in eye space for the light, texture coordinates for the pattern.
#version 330 core

out vec3 vNormal;   // eye space
out vec2 vST;

void main() {
    vNormal = uNormalMatrix * aNormal;
    vST = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
