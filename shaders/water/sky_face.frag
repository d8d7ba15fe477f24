// G15.1 A face of a cube map of the sky.
#version 410 core
#include "modern/sky.glsl"

in vec3 vDirection;
out vec4 fColor;

void main() {
    fColor = vec4(skyColor(normalize(vDirection)), 1.);
}
