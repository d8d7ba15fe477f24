// G16.1 Sums: one invocation per element.
#version 430 core
layout(local_size_x = 1) in;

layout(std430) readonly buffer First { float first[]; };
layout(std430) readonly buffer Second { float second[]; };
layout(std430) writeonly buffer Sum { float sum[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    sum[i] = first[i] + second[i];
}
