// The light on one colour.
#version 330 core

uniform vec3 uColor;

in float vLight;

out vec4 fColor;

void main() {
    fColor = vec4(vLight * uColor, 1.);
}
