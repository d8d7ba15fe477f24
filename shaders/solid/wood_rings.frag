// G14.6a Wood rings: four sections through a log, each with more turbulence than the one before it.
#version 410 core
#include "wood.glsl"

uniform vec4 uPowers;
uniform float uPart;    // of the section that is seen
uniform float uAspect;  // width / height of the picture

in vec2 vST;
out vec4 fColor;

void main() {
    ivec2 panel = ivec2(2. * vST);
    vec2 place = uPart * (fract(2. * vST) - .5) * vec2(uAspect, 1.) + .5;
    fColor = vec4(woodColor(vec3(place, .5), uPowers[panel.x + 2 * (1 - panel.y)]), 1.);
}
