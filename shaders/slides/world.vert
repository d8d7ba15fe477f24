// S15 Eye space for the geometry stage.
#version 400

out vec3 vNormal;

void main() {
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewMatrix * aVertex;
}
