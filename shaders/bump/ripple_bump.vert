// SH032 Ripple bump map: model position for the waves, eye position for the light.
#version 330 core

out vec2 vXY;         // model space
out vec3 vPosition;   // eye space

void main() {
    vXY = aVertex.xy;
    vPosition = vec3(uModelViewMatrix * aVertex);
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
