// Turned threads: the direction of the threads is the sphere's tangent, turned about the normal.
#version 330 core

uniform float uThread;   // degrees: 0 along the meridians, 90 along the parallels

out vec3 vPosition;   // eye space
out vec3 vTangent;    // eye space
out vec3 vNormal;     // eye space

void main() {
    vec3 along = cos(radians(uThread)) * aTangent + sin(radians(uThread)) * cross(aTangent, aNormal);
    vPosition = vec3(uModelViewMatrix * aVertex);
    vTangent = mat3(uModelViewMatrix) * along;
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
