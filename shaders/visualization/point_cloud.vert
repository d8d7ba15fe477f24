// SH096 Point cloud: the model positions of the points.
#version 330 core

out vec3 vModel;

void main() {
    vModel = aVertex.xyz;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
