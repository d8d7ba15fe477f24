#version 430 core
// Shows a board of cells.
in vec2 vST;
uniform usampler2D uLife;
uniform vec3 uAlive, uDead;
out vec4 fColor;

void main() {
    uint lives = texture(uLife, vST).r;
    fColor = vec4(lives == 1u ? uAlive : uDead, 1.);
}
