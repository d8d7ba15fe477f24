// G12.5b The height of the ground.
#version 410 core

in vec3 vPlace;
out float fHeight;

void main() {
    fHeight = vPlace.y;
}
