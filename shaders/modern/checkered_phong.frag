// G9.M Phong shading, on a checkerboard in the plane y = 0 if uTiles is not 0.
#version 430 core
#include "lighting.glsl"

uniform vec3 cameraPosition;
uniform float uTiles = 0.;  // per unit of length

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(light.position - vPlace), toEye = normalize(cameraPosition - vPlace);
    vec2 tile = floor(uTiles * vPlace.xz);
    float shade = mod(tile.x + tile.y, 2.) == 0. ? 1. : .55;
    vec3 color = shade * (ambientLight() + diffuseLight(normal, toLight)) + specularLight(normal, toLight, toEye);
    fColor = vec4(color, 1.);
}
