// G15.2 Floor: checkered and lit.
#version 430 core
#include "floor.glsl"

in vec3 vPlace;
out vec4 fColor;

void main() {
    fColor = vec4(litFloor(tileColor(vPlace.xz), vec3(0., 1., 0.), vPlace), 1.);
}
