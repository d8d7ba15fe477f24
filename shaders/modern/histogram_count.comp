// Counts the pixels of each of 256 brightnesses: first per group in shared memory, then for all.
#version 430 core

layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D uImage;
layout(std430) buffer Counts { uint counts[256]; };

shared uint sCounts[256];

void main() {
    sCounts[gl_LocalInvocationIndex] = 0u;
    barrier();
    ivec2 place = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(place, textureSize(uImage, 0)))) {
        float brightness = dot(texelFetch(uImage, place, 0).rgb, vec3(.299, .587, .114));
        atomicAdd(sCounts[int(255. * brightness + .5)], 1u);
    }
    barrier();
    atomicAdd(counts[gl_LocalInvocationIndex], sCounts[gl_LocalInvocationIndex]);
}
