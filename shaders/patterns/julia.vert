// D09 Julia: x and y of the model are the start value.
#version 330 core

out vec2 vXY;         // model space
out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space

void main() {
    vXY = aVertex.xy;
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
