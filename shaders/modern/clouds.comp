// G14.7 Cloud recipe: turbulence, from blue sky to white clouds. With a large sharpness the clouds have edges.
#version 430 core
#include "noise_recipe.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(r8) uniform writeonly image3D uClouds;

uniform float uZoom;        // of the coarsest noise, in texels
uniform float uThreshold;   // of the turbulence, 0..256
uniform float uSharpness;   // 0: no threshold

void main() {
    ivec3 size = imageSize(uClouds), texel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(texel, size))) return;
    float t = turbulence(vec3(texel), uZoom, size);
    float cloud = uSharpness > 0. ? logistic(t - uThreshold, uSharpness) : t / 256.;
    imageStore(uClouds, texel, vec4(cloud));
}
