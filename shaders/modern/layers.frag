// G16.W Work groups: four layers of an array side by side.
#version 430 core

uniform sampler2DArray uLayers;

in vec2 vST;
out vec4 fColor;

void main() {
    vec2 two = 2. * vST;
    float layer = 2. * (1. - floor(two.y)) + floor(two.x);
    vec2 inside = (fract(two) - .03) / .94;
    bool isFrame = any(lessThan(inside, vec2(0.))) || any(greaterThan(inside, vec2(1.)));
    fColor = isFrame ? vec4(.1, .1, .1, 1.) : texture(uLayers, vec3(inside, layer));
}
