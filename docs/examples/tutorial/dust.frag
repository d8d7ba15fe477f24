// Faint light, which adds up where grains are many.
#version 330 core

out vec4 fColor;

void main() {
    fColor = vec4(.35, .3, .2, 1.);
}
