// S26 A Gaussian of 5 x 5 texels in blocks of 8 x 8: a group reads its block and a rim of two texels once, into shared memory.
#version 430
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D uPicture;
writeonly uniform image2D uFiltered;

const int kBlock = 8, kRim = 2, kTile = kBlock + 2 * kRim;
const float kWeights[5] = float[5](1., 4., 6., 4., 1.);

shared vec3 sTile[kTile * kTile];

void main() {
    ivec2 size = textureSize(uPicture, 0), corner = kBlock * ivec2(gl_WorkGroupID.xy) - kRim;
    // 144 texels for 64 invocations.
    for (int i = int(gl_LocalInvocationIndex); i < kTile * kTile; i += kBlock * kBlock) {
        ivec2 place = clamp(corner + ivec2(i % kTile, i / kTile), ivec2(0), size - 1);
        sTile[i] = texelFetch(uPicture, place, 0).rgb;
    }
    memoryBarrierShared();
    barrier();

    ivec2 place = ivec2(gl_GlobalInvocationID.xy), inTile = ivec2(gl_LocalInvocationID.xy);
    vec3 sum = vec3(0.);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x)
            sum += kWeights[x] * kWeights[y] * sTile[(inTile.y + y) * kTile + inTile.x + x];
    if (all(lessThan(place, size))) imageStore(uFiltered, place, vec4(sum / 256., 1.));
}
