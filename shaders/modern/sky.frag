// G15.1 Sky: a gradient, a sun and clouds.
#version 430 core
#include "sky.glsl"

in vec3 vDirection;
out vec4 fColor;

void main() {
    fColor = vec4(skyColor(normalize(vDirection)), 1.);
}
