// G12.f9 Terrain: the ground in the light from one side.
#version 430 core
#include "terrain_light.glsl"

in vec3 vPlace;
in vec2 vST;
out vec4 fColor;

void main() {
    fColor = vec4(litGround(vPlace, vST), 1.);
}
