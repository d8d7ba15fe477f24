// Light of one lamp beside the eye, at every vertex.
#version 330 core

uniform mat4 uModelViewMatrix;
uniform mat4 uProjectionMatrix;
uniform mat3 uNormalMatrix;

in vec4 aVertex;
in vec3 aNormal;

out float vLight;

void main() {
    vec3 normal = normalize(uNormalMatrix * aNormal);
    vLight = .2 + .8 * max(dot(normal, normalize(vec3(-1., 2., 3.))), 0.);
    gl_Position = uProjectionMatrix * uModelViewMatrix * aVertex;
}
