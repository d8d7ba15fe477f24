// S13 Bricks in running bond.
#version 110

uniform vec3 uBrickColor, uMortarColor;
uniform vec2 uBrickSize, uBrickPct;

varying float vLight;
varying vec2 vWall;

void main() {
    vec2 place = vWall / uBrickSize;
    if (fract(.5 * place.y) > .5) place.x += .5;
    vec2 brick = step(fract(place), uBrickPct);
    gl_FragColor = vec4(vLight * mix(uMortarColor, uBrickColor, brick.x * brick.y), 1.);
}
