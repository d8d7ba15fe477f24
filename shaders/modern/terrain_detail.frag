// G12.5 Level of detail: the ground, or the number of cuts from blue (1) to red (32 and more).
#version 430 core
#include "terrain_light.glsl"

uniform bool uShowLevels;

in vec3 vPlace;
in vec2 vST;
in float vCuts;
out vec4 fColor;

void main() {
    vec3 color = litGround(vPlace, vST);
    if (uShowLevels) {
        float cuts = clamp(log2(vCuts) / 5., 0., 1.);
        vec3 scale = clamp(vec3(2. * cuts - .5, 1.5 - abs(3. * cuts - 1.5), 1.5 - 2. * cuts), 0., 1.);
        color = scale * (.3 + .7 * dot(color, vec3(1. / 3.)));
    }
    fColor = vec4(color, 1.);
}
