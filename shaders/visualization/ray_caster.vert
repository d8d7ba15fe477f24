// SH103 Volume ray casting: where each line of sight enters the volume, and its direction, in model space.
#version 330 core

out vec3 vModel;
out vec3 vSight;

void main() {
    // Perspective: from the eye to the vertex. Orthographic: the same direction everywhere.
    vec4 position = uModelViewMatrix * aVertex;
    bool orthographic = uProjectionMatrix[3][3] == 1.;
    vec3 sight = orthographic ? vec3(0., 0., -1.) : position.xyz;
    vSight = vec3(uModelViewMatrixInverse * vec4(sight, 0.));
    vModel = aVertex.xyz;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
