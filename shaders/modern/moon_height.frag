// G10.2 Height map of a part of the Moon. s is the longitude and t the latitude.
#version 430 core
#include "craters.glsl"

uniform vec4 uArea;  // west, south, east and north border in degrees

in vec2 vST;
out float fHeight;

void main() {
    vec2 angle = radians(mix(uArea.xy, uArea.zw, vST));
    fHeight = moonHeight(vec3(-cos(angle.x) * cos(angle.y), sin(angle.y), sin(angle.x) * cos(angle.y)));
}
