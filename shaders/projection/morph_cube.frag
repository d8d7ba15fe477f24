// SH126 Morph: normals of the triangles, because those of the model no longer fit.
#version 330 core

#include "../common/light.glsl"

uniform vec3 uColor;

in vec3 vPosition;

out vec4 fColor;

const vec3 kLight = vec3(-4., 7., 4.);   // eye space

void main() {
    vec3 normal = cross(dFdx(vPosition), dFdy(vPosition));
    float size = length(normal);
    normal = size > 0. ? normal / size : vec3(0., 0., 1.);
    fColor = vec4(adsLight(uColor, normal, vPosition, kLight, 30.), 1.);
}
