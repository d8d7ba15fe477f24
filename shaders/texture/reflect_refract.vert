// SH035 Reflection and refraction: the line of sight and the normal in eye space.
#version 330 core

out vec3 vPosition;
out vec3 vNormal;

void main() {
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
