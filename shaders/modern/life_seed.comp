#version 430 core
// Fills the board: each cell lives with the probability uDensity.
layout(local_size_x = 8, local_size_y = 8) in;

layout(r8ui) uniform writeonly uimage2D uOut;
uniform float uDensity;
uniform int uSeed;

// A hash of three numbers with well-mixed bits (PCG; Jarzynski and Olano, 2020).
uint hash(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    return v.x;
}

void main() {
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(cell, imageSize(uOut)))) return;
    float random = float(hash(uvec3(cell, uSeed)) >> 8u) / 16777216.;
    imageStore(uOut, cell, uvec4(random < uDensity ? 1u : 0u));
}
