// R51 Brick: bricks in mortar, either by comparing with the edge or by the integral of both trains of pulses over a pixel.
#version 330 core
#include "pulse.glsl"

uniform bool uIntegrated;
uniform vec3 uBrickColor, uMortarColor;
uniform vec2 uBrickSize;        // with the mortar
uniform vec2 uBrickShare;       // of the size that is brick

in vec2 vPlace;

out vec4 fColor;

void main() {
    vec2 place = vPlace / uBrickSize;
    vec2 w = max(fwidth(place), 1e-5);
    // Every second row starts half a brick later.
    if (fract(place.y * .5) > .5) place.x += .5;
    vec2 brick = uIntegrated ? vec2(pulseMean(place.x, w.x, uBrickShare.x), pulseMean(place.y, w.y, uBrickShare.y))
                             : step(fract(place), uBrickShare);
    fColor = vec4(mix(uMortarColor, uBrickColor, brick.x * brick.y), 1.);
}
