// SH030 Brick: the fractions of the angle around the axis and of the height decide between brick and mortar.
#version 330 core

uniform float uRows;      // rows per unit of height
uniform float uBricks;    // bricks around
uniform float uMortar;    // share of a row that is mortar
uniform vec3 uBrickColor;
uniform vec3 uMortarColor;

in vec3 vModel;
in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-4., 6., 5.);   // eye space

void main() {
    float row = vModel.y * uRows;
    float turn = dot(vModel.xz, vModel.xz) > 0. ? atan(vModel.z, vModel.x) / 6.2831853 : 0.;
    float brick = turn * floor(uBricks) + .5 * mod(floor(row), 2.);
    vec2 inBrick = fract(vec2(brick, row));
    vec2 joint = vec2(.5 * uMortar, uMortar);
    bool isBrick = all(greaterThan(inBrick, joint));

    vec3 color = isBrick ? uBrickColor : uMortarColor;
    float light = .25 + .75 * abs(dot(normalize(vNormal), normalize(kLight - vPosition)));
    fColor = vec4(light * color, 1.);
}
