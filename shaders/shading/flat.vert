// SH012 Flat shading: the light of the last vertex holds for the whole triangle.
#version 330 core

flat out float vIntensity;

const vec3 kLight = vec3(-4., 5., 6.);   // eye space

void main() {
    vec3 position = vec3(uModelViewMatrix * aVertex);
    vec3 normal = normalize(uNormalMatrix * aNormal);
    vIntensity = .2 + .8 * abs(dot(normal, normalize(kLight - position)));
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
