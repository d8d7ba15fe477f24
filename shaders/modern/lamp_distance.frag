// The distance from the lamp.
#version 430 core

uniform vec3 uLamp;

in vec3 vPlace;
out float fDistance;

void main() {
    fDistance = distance(vPlace, uLamp);
}
