// SH014 Phong shading: eye-space position and normal, which are interpolated.
#version 330 core

out vec3 vPosition;
out vec3 vNormal;

void main() {
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
