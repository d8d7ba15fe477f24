// Tutorial: a white point, brighter or darker.
#version 330 core

in float vBrightness;

out vec4 fColor;

void main() {
    fColor = vec4(vec3(vBrightness), 1.);
}
