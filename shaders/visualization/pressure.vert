// EX14.2 Pressure: passes the pressure of each vertex on.
#version 330 core

in float aPressure;

out float vPressure;
out vec3 vNormal;

void main() {
    vPressure = aPressure;
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
