// G14.5n White noise recipe: a random value in each texel.
#version 430 core
#include "noise_recipe.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(r8) uniform writeonly image3D uNoise;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(texel, imageSize(uNoise)))) return;
    imageStore(uNoise, texel, vec4(randomValue(texel)));
}
