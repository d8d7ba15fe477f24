// New solids: eye-space normals and texture coordinates.
#version 330 core

out vec3 vNormal;
out vec2 vST;

void main() {
    vNormal = uNormalMatrix * aNormal;
    vST = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
