// Hills over the square -1..1, as a function of a place, and their light.
#include "modern/noise.glsl"

uniform float uRelief;

float hillHeight(vec2 place) {
    return uRelief * fractalNoise(vec3(2.2 * place + vec2(3.7, 1.2), .35), 4);
}

vec3 hillNormal(vec2 place) {
    const float kStep = .004;
    float east = hillHeight(place + vec2(kStep, 0.)) - hillHeight(place - vec2(kStep, 0.));
    float south = hillHeight(place + vec2(0., kStep)) - hillHeight(place - vec2(0., kStep));
    return normalize(vec3(-east, 2. * kStep, -south));
}

/// Grass, and rock where it is steep.
vec3 hillColor(vec3 normal) {
    return mix(vec3(.46, .41, .35), vec3(.35, .48, .22), smoothstep(.78, .92, normal.y));
}
