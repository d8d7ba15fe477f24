// The largest change of a point in one round, found by one work group.
#version 430 core
layout(local_size_x = 256) in;

const int SIDE = 48;

layout(std430) readonly buffer From { float from[]; };
layout(std430) readonly buffer To { float to[]; };
layout(std430) writeonly buffer Change { float change[]; };

shared float largest[256];

void main() {
    int own = int(gl_LocalInvocationIndex);
    float most = 0.;
    for (int i = own; i < SIDE * SIDE; i += 256) most = max(most, abs(to[i] - from[i]));
    largest[own] = most;
    for (int span = 128; span > 0; span /= 2) {
        barrier();
        if (own < span) largest[own] = max(largest[own], largest[own + span]);
    }
    if (own == 0) change[0] = largest[0];
}
