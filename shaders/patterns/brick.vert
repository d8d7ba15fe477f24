// SH030 Brick: the model position decides the brick.
#version 330 core

out vec3 vModel;      // model space
out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space

void main() {
    vModel = aVertex.xyz;
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
