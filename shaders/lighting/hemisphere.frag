// R25 Light from the two halves of a sphere: mix(ground, sky, 1/2 + 1/2 cos), where cos is 1 for a normal that points up.
#version 330 core

uniform vec3 uSkyColor, uGroundColor, uColor;
uniform vec3 uUp;         // eye space

in vec3 vNormal;
out vec4 fColor;

void main() {
    float up = dot(normalize(vNormal), normalize(uUp));
    fColor = vec4(uColor * mix(uGroundColor, uSkyColor, .5 + .5 * up), 1.);
}
