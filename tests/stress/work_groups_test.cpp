// Compute programs and control stages whose invocations work together (exercises' accuracy table 44 to 46):
// results whatever the shape of the groups, and sums over shared memory and outputs that barriers order.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

#include "gpu/context/capabilities.h"
#include "support.h"

namespace glibra::stress {
namespace {

#define NEEDS_COMPUTE() \
    if (!context().capabilities().compute) GTEST_SKIP() << "OpenGL 4.3 is needed"

/// A hash of a place: no two neighbours are alike (G. Marsaglia, Xorshift RNGs, 2003).
std::uint32_t hashOf(std::uint32_t x) {
    x = x * 747796405U + 2891336453U;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    return x & 0xFFFFU;
}

const std::string kHash = R"(uint hash(uint x) {
    x = x * 747796405u + 2891336453u;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    return x & 0xFFFFu;
})";

/// Shows a texture of whole numbers as floats.
const std::string kShow = R"(Fragment inline
#version 330 core
uniform usampler2D uResult;
out vec4 fColor;
void main() { fColor = vec4(vec3(texelFetch(uResult, ivec2(gl_FragCoord.xy), 0).r), 1.); }
EndFragment
Program Show uResult result
Fill window with Show
)";

TEST(WorkGroups, GiveTheSameWhateverTheirShapeAndPieces) {
    NEEDS_COMPUTE();
    // 61 x 37 texels, which no shape divides.
    constexpr int kWidth = 61, kHeight = 37;
    for (const auto& [x, y] : {std::pair{1, 1}, {8, 8}, {16, 16}, {32, 1}, {1, 32}, {7, 3}, {1024, 1}})
        for (const int tiles : {1, 3}) {
            const FloatPicture picture = draw(fmt::format("WindowSize {} {}\nTexture2D result {} {} r32ui\n",
                                                          kWidth, kHeight, kWidth, kHeight) +
                                              fmt::format(R"(Compute inline
#version 430 core
layout(local_size_x = {}, local_size_y = {}) in;
layout(r32ui) uniform writeonly uimage2D uResult;
)",
                                                          x, y) +
                                              kHash + R"(
void main() {
    ivec2 place = ivec2(gl_GlobalInvocationID.xy), size = imageSize(uResult);
    if (place.x >= size.x || place.y >= size.y) return;
    imageStore(uResult, place, uvec4(hash(uint(place.y * size.x + place.x))));
}
EndCompute
Program Hash uResult result
)" + fmt::format("Dispatch Hash over result tiles {}\n", tiles) +
                                              kShow);
            ASSERT_EQ(picture.width, kWidth);
            int wrong = 0;
            for (int row = 0; row < kHeight; ++row)
                for (int column = 0; column < kWidth; ++column) {
                    const auto place = static_cast<std::uint32_t>((kHeight - 1 - row) * kWidth + column);
                    wrong += picture.at(column, row)[0] == static_cast<float>(hashOf(place)) ? 0 : 1;
                }
            EXPECT_EQ(wrong, 0) << x << " x " << y << " in " << tiles;
        }
}

/// The sums of `groups` runs of `size` hashes. Without barriers an invocation may read what another one has
/// not written yet; what that gives is not defined.
FloatPicture sumsOf(int groups, int size, bool hasBarriers) {
    const std::string barrier = hasBarriers ? "memoryBarrierShared(); barrier();" : "";
    return draw(fmt::format("WindowSize {0} 1\nTexture2D result {0} 1 r32ui\n", groups) +
                fmt::format(R"(Compute inline
#version 430 core
layout(local_size_x = {0}) in;
layout(r32ui) uniform writeonly uimage2D uResult;
shared uint sums[{0}];
)",
                            size) +
                kHash +
                fmt::format(R"(
void main() {{
    uint i = gl_LocalInvocationIndex;
    sums[i] = hash(gl_GlobalInvocationID.x);
    {0}
    for (uint half_ = {1}u / 2u; half_ > 0u; half_ /= 2u) {{
        if (i < half_) sums[i] += sums[i + half_];
        {0}
    }}
    if (i == 0u) imageStore(uResult, ivec2(gl_WorkGroupID.x, 0), uvec4(sums[0]));
}}
EndCompute
Program Sum uResult result
Dispatch Sum {2}
)",
                            barrier, size, groups) +
                kShow);
}

TEST(SharedSums, AreExactWithBarriersWhateverTheSizeOfTheGroup) {
    NEEDS_COMPUTE();
    constexpr int kGroups = 200;
    for (const int size : {1, 2, 8, 32, 64, 128, 256, 1024}) {
        const auto wrongIn = [&](const FloatPicture& picture) {
            int wrong = 0;
            for (int group = 0; group < kGroups; ++group) {
                std::uint32_t sum = 0;  // below 2^26; floats are exact to 2^24
                for (int i = 0; i < size; ++i) sum += hashOf(static_cast<std::uint32_t>(group * size + i));
                wrong += picture.at(group, 0)[0] == static_cast<float>(sum) ? 0 : 1;
            }
            return wrong;
        };
        const FloatPicture ordered = sumsOf(kGroups, size, true);
        ASSERT_EQ(ordered.width, kGroups);
        EXPECT_EQ(wrongIn(ordered), 0) << size;
        // Only shown: without barriers every result is allowed.
        const FloatPicture racing = sumsOf(kGroups, size, false);
        ASSERT_EQ(racing.width, kGroups);
        std::printf("groups of %d: %d of %d sums are wrong without barriers\n", size, wrongIn(racing),
                    kGroups);
    }
}

TEST(AtomicSums, OfAHistogramAreExact) {
    NEEDS_COMPUTE();
    // 16 bins over 100,000 hashes; all invocations of a bin add to one number.
    constexpr int kBins = 16, kCount = 100'000;
    const FloatPicture picture =
        draw(fmt::format("WindowSize {0} 1\nTexture2D result {0} 1 r32ui\n", kBins) + R"(Compute inline
#version 430 core
layout(local_size_x = 100) in;
layout(r32ui) uniform coherent uimage2D uResult;
)" + kHash + R"(
void main() { imageAtomicAdd(uResult, ivec2(hash(gl_GlobalInvocationID.x) & 15u, 0), 1u); }
EndCompute
Program Count uResult result
)" + fmt::format("Dispatch Count {}\n", kCount / 100) +
             kShow);
    ASSERT_EQ(picture.width, kBins);
    std::vector<int> counts(kBins);
    for (std::uint32_t i = 0; i < kCount; ++i) ++counts[hashOf(i) & 15U];
    for (int bin = 0; bin < kBins; ++bin)
        EXPECT_EQ(picture.at(bin, 0)[0], static_cast<float>(counts[static_cast<std::size_t>(bin)])) << bin;
}

TEST(ControlStage, ReadsOutputsOfOtherInvocationsAfterABarrier) {
    // Each invocation writes its number; after the barrier it adds up all of them, into a colour.
    for (const int points : {1, 3, 8, 32}) {
        const FloatPicture picture = draw(fmt::format(R"(WindowSize 16 16
Vertex inline
#version 410 core
void main() {{ gl_Position = vec4(0.); }}
EndVertex
TessControl inline
#version 410 core
layout(vertices = {0}) out;
out float vNumber[];
patch out float vSum;
void main() {{
    vNumber[gl_InvocationID] = float(gl_InvocationID + 1);
    barrier();
    if (gl_InvocationID == {0} - 1) {{
        float sum = 0.;
        for (int i = 0; i < {0}; ++i) sum += vNumber[i];
        vSum = sum;
    }}
    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelOuter[3] = 1.;
    gl_TessLevelInner[0] = gl_TessLevelInner[1] = 1.;
}}
EndTessControl
TessEvaluation inline
#version 410 core
layout(quads, equal_spacing, ccw) in;
in float vNumber[];
patch in float vSum;
out float vColor;
void main() {{
    vColor = vSum;
    gl_Position = vec4(2. * gl_TessCoord.xy - 1., 0., 1.);
}}
EndTessEvaluation
Fragment inline
#version 410 core
in float vColor;
out vec4 fColor;
void main() {{ fColor = vec4(vec3(vColor), 1.); }}
EndFragment
Program Patches
NumPatchVertices 1
Vertices patches 1
)",
                                                      points));
        ASSERT_EQ(picture.width, 16);
        const float expected = static_cast<float>(points * (points + 1) / 2);
        EXPECT_EQ(
            picture.count([&](const auto& rgb) { return std::abs(rgb[0] - expected) > 1e-4F * expected; }),
            0U)
            << points;
    }
}

}  // namespace
}  // namespace glibra::stress
