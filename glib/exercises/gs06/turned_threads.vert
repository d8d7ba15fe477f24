// Threads from pole to pole. Exercise: turn them.
#version 330 core

uniform float uThread;   // degrees: 0 along the meridians, 90 along the parallels

out vec3 vPosition;   // eye space
out vec3 vTangent;    // eye space
out vec3 vNormal;     // eye space

void main() {
    vec3 along = uThread < -90. ? aNormal : aTangent;   // Change this; it only keeps the uniform in use.
    vPosition = vec3(uModelViewMatrix * aVertex);
    vTangent = mat3(uModelViewMatrix) * along;
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
