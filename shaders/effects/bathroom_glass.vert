// SH119 Bathroom glass: the line of sight in eye space and the place on the pane.
#version 330 core

out vec3 vModel;      // model space
out vec3 vPosition;   // eye space

void main() {
    vModel = aVertex.xyz;
    vPosition = vec3(uModelViewMatrix * aVertex);
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
