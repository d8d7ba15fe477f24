// R01 Bricks in running bond in the model's x and y: every second row is shifted by half a brick.
#version 140

uniform vec3 BrickColor, MortarColor;
uniform vec2 BrickSize, BrickPct;

in float vLight;
in vec3 vPlace;
out vec4 fColor;

void main() {
    vec2 place = vPlace.xy / BrickSize;
    if (fract(.5 * place.y) > .5) place.x += .5;
    vec2 isBrick = step(fract(place), BrickPct);
    fColor = vec4(vLight * mix(MortarColor, BrickColor, isBrick.x * isBrick.y), 1.);
}
