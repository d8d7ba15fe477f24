// SH015 Anisotropic: the thread direction is the sphere's tangent, towards its north pole.
#version 330 core

out vec3 vPosition;   // eye space
out vec3 vTangent;    // eye space
out vec3 vNormal;     // eye space

void main() {
    vPosition = vec3(uModelViewMatrix * aVertex);
    vTangent = mat3(uModelViewMatrix) * aTangent;
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
