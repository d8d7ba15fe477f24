// G15.4 G15.7 Heights of waves in a cube that repeats in all directions: slices y of it are moments of the water.
#version 430 core
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "noise.glsl"

layout(r16f) uniform writeonly image3D uHeights;

const float kTurn = 6.2831853;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    ivec3 size = imageSize(uHeights);
    if (any(greaterThanEqual(texel, size))) return;
    vec3 p = (vec3(texel) + .5) / vec3(size);
    float height = .25 * sin(kTurn * (p.x + p.z - p.y));
    float amplitude = .6;
    for (int octave = 4; octave <= 16; octave *= 2, amplitude *= .5)
        height += amplitude * gradientNoise(float(octave) * p, octave);
    imageStore(uHeights, texel, vec4(height));
}
