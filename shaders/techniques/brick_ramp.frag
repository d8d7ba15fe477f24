// R02 How the bricks count: inside each one, grey rises to the right and upward.
#version 140

uniform vec2 BrickSize;

in vec3 vPlace;
out vec4 fColor;

void main() {
    vec2 place = vPlace.xy / BrickSize;
    if (fract(.5 * place.y) > .5) place.x += .5;
    place = fract(place);
    fColor = vec4(vec3(.5 * (place.x + place.y)), 1.);
}
