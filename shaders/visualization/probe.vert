// SH101 Probe: eye-space position: the field is fixed in front of the eye, and the probe moves through it.
#version 330 core

out vec3 vPosition;
out vec3 vNormal;

void main() {
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
