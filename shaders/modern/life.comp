#version 430 core
// One generation: a cell lives on with two or three living neighbours; with three a new one is born.
// The board has no edges: its left side joins its right side, and its top its bottom.
layout(local_size_x = 8, local_size_y = 8) in;

layout(r8ui) uniform readonly uimage2D uIn;
layout(r8ui) uniform writeonly uimage2D uOut;

void main() {
    ivec2 size = imageSize(uOut);
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(cell, size))) return;
    uint neighbours = 0u;
    for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++)
            if (x != 0 || y != 0) neighbours += imageLoad(uIn, (cell + ivec2(x, y) + size) % size).r;
    bool lives = imageLoad(uIn, cell).r == 1u;
    imageStore(uOut, cell, uvec4(neighbours == 3u || (lives && neighbours == 2u) ? 1u : 0u));
}
