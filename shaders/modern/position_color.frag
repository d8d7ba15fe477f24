// G4.1b Tumbling cubes: the colour of the place, darker with uFade.
#version 330 compatibility

uniform float uFade;

in vec3 vColor;
out vec4 fColor;

void main() {
    fColor = vec4(uFade * vColor, 1.);
}
