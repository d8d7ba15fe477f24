// Noise as a volume: the place in the cube, and the eye as seen from there.
#version 330 core

out vec3 vModel;
out vec3 vEye;      // model space

void main() {
    vModel = aVertex.xyz;
    vEye = vec3(uModelViewMatrixInverse * vec4(0., 0., 0., 1.));
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
