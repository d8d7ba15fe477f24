// Everything in eye space, and where on the model a point is.
#version 330 core

out vec3 vModel;
out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space
out vec3 vTangent;    // eye space
out vec2 vST;

void main() {
    vModel = aVertex.xyz;
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = uNormalMatrix * aNormal;
    vTangent = mat3(uModelViewMatrix) * aTangent;
    vST = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
