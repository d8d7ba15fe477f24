// Each inner point becomes the mean of its four neighbours (Jacobi's method for Laplace's equation).
#version 430 core
layout(local_size_x = 16, local_size_y = 16) in;

const int SIDE = 48;

layout(std430) readonly buffer From { float from[]; };
layout(std430) writeonly buffer To { float to[]; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, ivec2(SIDE)))) return;
    int i = SIDE * at.y + at.x;
    bool isRim = any(equal(at, ivec2(0))) || any(equal(at, ivec2(SIDE - 1)));
    to[i] = isRim ? from[i] : .25 * (from[i - 1] + from[i + 1] + from[i - SIDE] + from[i + SIDE]);
}
