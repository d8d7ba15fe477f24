// EX16.1 Oil slick under the sky: the place on the road, which is the plane z = 0 of the world.
#version 330 core

out vec2 vXY;

void main() {
    vXY = aVertex.xy;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
