// The running sums of the counts (Hillis and Steele 1986), as shares of all pixels.
#version 430 core

layout(local_size_x = 256) in;

layout(std430) readonly buffer Counts { uint counts[256]; };
layout(std430) writeonly buffer Shares { float shares[256]; };

shared uint sSums[256];

void main() {
    uint i = gl_LocalInvocationID.x;
    sSums[i] = counts[i];
    barrier();
    for (uint reach = 1u; reach < 256u; reach *= 2u) {
        uint before = i >= reach ? sSums[i - reach] : 0u;
        barrier();
        sSums[i] += before;
        barrier();
    }
    shares[i] = float(sSums[i]) / float(sSums[255]);
}
