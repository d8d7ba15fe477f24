// SH123 Disco ball, the ball itself: the direction from its centre.
#version 330 core

out vec3 vNormal;   // model space

void main() {
    vNormal = aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
