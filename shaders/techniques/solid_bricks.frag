// R05 Bricks with three sizes: they end in depth, too, and every second row is shifted along both of its axes.
#version 140

uniform vec3 BrickColor, MortarColor;
uniform vec3 BrickSize, BrickPct;

in float vLight;
in vec3 vPlace;
out vec4 fColor;

void main() {
    vec3 place = vPlace / BrickSize;
    if (fract(.5 * place.y) > .5) place.xz += .5;
    vec3 isBrick = step(fract(place), BrickPct);
    fColor = vec4(vLight * mix(MortarColor, BrickColor, isBrick.x * isBrick.y * isBrick.z), 1.);
}
