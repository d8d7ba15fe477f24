// SH013 Gouraud shading: ambient, diffuse and specular light at every vertex.
#version 330 core

#include "../common/light.glsl"

uniform vec3 uColor;
uniform float uShininess;

out vec3 vColor;

const vec3 kLight = vec3(-4., 5., 6.);   // eye space

void main() {
    vec3 position = vec3(uModelViewMatrix * aVertex);
    vColor = adsLight(uColor, normalize(uNormalMatrix * aNormal), position, kLight, uShininess);
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
