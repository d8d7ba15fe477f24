// R26 The probe as surroundings.
#version 330 core
#include "../common/direction.glsl"

uniform sampler2D uSharpMap;
uniform float uExposure;

in vec3 vModel;
out vec4 fColor;

void main() {
    vec3 light = uExposure * textureLod(uSharpMap, placeOf(vModel), 0.).rgb;
    fColor = vec4(sqrt(light / (1. + .35 * light)), 1.);
}
