// G5.f7 A checkerboard with sharp edges, or a picture that repeats.
#version 430 core

uniform sampler2D uPicture;
uniform bool uChecker;
uniform float uCells;   // in each direction

in vec2 vST;
out vec4 fColor;

void main() {
    vec2 cell = floor(vST * uCells);
    float checker = mod(cell.x + cell.y, 2.);
    fColor = uChecker ? vec4(vec3(checker), 1.) : texture(uPicture, vST * uCells / 16.);
}
