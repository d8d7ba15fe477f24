// SH110 LIC on a box: the place in the cube 0..1 of the field.
#version 330 core

uniform mat4 uToWorld;

out vec3 vSTP;
out vec3 vNormal;   // eye space

void main() {
    vSTP = .5 + .5 * vec3(uToWorld * (uModelViewMatrix * aVertex));
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
