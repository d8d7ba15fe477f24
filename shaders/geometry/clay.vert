// SH077 Silhouettes, the body: eye-space normals.
#version 330 core

out vec3 vNormal;

void main() {
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
