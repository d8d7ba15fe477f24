// SH115 Oil slick: the place on the road.
#version 330 core

out vec2 vXY;   // model space

void main() {
    vXY = aVertex.xy;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
