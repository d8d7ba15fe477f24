// G14.5n White noise: a random value in each texel of one layer of a texture in three dimensions.
#version 410 core
#include "modern/noise_recipe.glsl"

uniform int uLayer;

out float fNoise;

void main() {
    fNoise = randomValue(ivec3(gl_FragCoord.xy, uLayer));
}
