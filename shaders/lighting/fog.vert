// R11 The distance along the direction of view.
#version 330 core

out float vDistance;
out vec3 vNormal;     // eye space

void main() {
    vDistance = -(uModelViewMatrix * aVertex).z;
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
