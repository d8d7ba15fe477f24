// Start, the teapot: positions and normals in eye space, where the light is, for lighting per fragment.
#version 330 core

out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space, not of unit length
out vec2 vST;
out float vHeight;    // model space

void main() {
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = uNormalMatrix * aNormal;
    vST = aTexCoord0.st;
    vHeight = aVertex.y;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
