// S24 Work groups: counts the invocations. Each group counts its own, and one of them adds that to the total.
#version 430 core
layout(local_size_x = 128) in;

layout(std430) buffer Counts { uint counts[]; };

shared uint ofGroup;

void main() {
    if (gl_LocalInvocationIndex == 0u) ofGroup = 0u;
    barrier();
    atomicAdd(ofGroup, 1u);
    barrier();
    if (gl_LocalInvocationIndex == 0u) atomicAdd(counts[1], ofGroup);
}
