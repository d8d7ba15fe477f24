// G12.2 Tiles: a square of pale tiles with dark joints and a cloudy glaze.
#version 430 core
#include "noise.glsl"

in vec2 vST;
out vec4 fColor;

void main() {
    vec2 inTile = fract(8. * vST);
    vec2 fromJoint = min(inTile, 1. - inTile);
    float joint = smoothstep(.03, .05, min(fromJoint.x, fromJoint.y));
    float glaze = .08 * gradientNoise(vec3(16. * vST, .5), 16) + .1 * randomOf(ivec3(floor(8. * vST), 0), 1u).x;
    fColor = vec4(mix(vec3(.16, .17, .18), vec3(.78, .80, .80) + glaze, joint), 1.);
}
