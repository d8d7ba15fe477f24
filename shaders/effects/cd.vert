// SH113 Compact disc: the direction of the track at every vertex, in eye space.
#version 330 core

out vec2 vXY;         // model space
out vec3 vPosition;   // eye space

void main() {
    vXY = aVertex.xy;
    vPosition = vec3(uModelViewMatrix * aVertex);
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
