// Where the reaction begins: a square and a disk with the second substance.
#version 430 core

in vec2 vST;
out vec2 fSubstances;

void main() {
    vec2 aside = abs(vST - vec2(.6, .4));
    bool isSeed = max(aside.x, aside.y) < .08 || length(vST - vec2(.3, .7)) < .06;
    fSubstances = isSeed ? vec2(.5, .25) : vec2(1., 0.);
}
