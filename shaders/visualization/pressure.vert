// EX14.2 Pressure: passes the pressure of each vertex on.
#version 330 core

in float aPressure;

out float vPressure;
out vec3 vNormal;
out float vAlong;

void main() {
    vPressure = aPressure;
    vNormal = uNormalMatrix * aNormal;
    vAlong = aVertex.z;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
