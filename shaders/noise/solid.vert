// SH039-SH043 Solid textures: model position for the noise, eye-space position and normal for the light.
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
