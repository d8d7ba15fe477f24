// Buffers and compute programs: what they write, against the same computed here, and what is refused.

#include <algorithm>

#include "modern_compute.h"

namespace glibra::test {
namespace {

constexpr const char* kAddBuffers = R"(
layout(local_size_x = 4) in;
layout(std430) readonly buffer A { float a[]; };
layout(std430) readonly buffer B { float b[]; };
layout(std430) writeonly buffer Sum { float sum[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(sum.length())) sum[i] = a[i] + b[i];
}
)";

/// Six sums, with the buffers bound by tags or by their names.
ComputeScene sums(bool isByName, const std::string& text = kAddBuffers) {
    ComputeScene scene(4, 4);
    const auto a = scene.buffer(isByName ? "A" : "a", "float", {}, {10, 12, 16, 18, 50, 17});
    const auto b = scene.buffer(isByName ? "B" : "b", "float", {}, {30, 14, 80, 20, 51, 12});
    const auto sum = scene.buffer(isByName ? "Sum" : "sum", "float", 6);
    const auto add = scene.compute("Add", text);
    scene::Dispatch dispatch = scene.over(add, scene::BufferView{sum});
    if (!isByName)
        scene.bind(
            dispatch,
            {{"A", scene::BufferView{a}}, {"B", scene::BufferView{b}}, {"Sum", scene::BufferView{sum}}});
    scene.scene.frame.add(dispatch);
    scene.window();
    return scene;
}

TEST_F(ModernCompute, AddsSixPairs) {
    for (const bool isByName : {false, true})
        EXPECT_EQ(resultOf(sums(isByName), scene::BufferIndex(2), 9),
                  (std::vector<double>{40, 26, 96, 38, 101, 29}));
}

TEST_F(ModernCompute, LayoutsOfTheDriverNeedNoCounting) {
    // Without a layout word the driver chooses one; some put each float into 16 bytes.
    std::string text = kAddBuffers;
    for (std::size_t at; (at = text.find("layout(std430) ")) != std::string::npos;) text.erase(at, 15);
    EXPECT_EQ(resultOf(sums(true, text), scene::BufferIndex(2), 6),
              (std::vector<double>{40, 26, 96, 38, 101, 29}));
}

TEST_F(ModernCompute, SkipsADispatchWhoseResultNobodyReads) {
    auto scene = load(sums(true));
    ASSERT_TRUE(scene);
    draw(*scene);
    const auto skipped = std::ranges::find_if(
        stats_.skipped, [](const plan::Skipped& each) { return each.what == "dispatch"; });
    ASSERT_NE(skipped, stats_.skipped.end());
    EXPECT_EQ(skipped->why, "'Add': nothing reads what it writes");
    EXPECT_EQ(scene->plan().dispatches.size(), 0U);
}

constexpr const char* kMixed = R"(
struct Item { vec3 position; float mass; mat2 turn; uint id; };
layout(local_size_x = 1) in;
layout(std430) buffer Items { uint count; Item items[]; };
void main() {
    count = uint(items.length());
    Item item = items[gl_GlobalInvocationID.x];
    item.position *= 2.;
    item.turn[1] += item.turn[0];
    item.id += 1u;
    items[gl_GlobalInvocationID.x] = item;
}
)";

TEST_F(ModernCompute, FillsStructuresInTheOrderOfTheirMembers) {
    ComputeScene made(4, 4);
    const auto items = made.buffer("Items", "Item", 2,
                                   {0,                                  // count
                                    1, 2, 3, .5, 10, 20, 30, 40, 7,     // items[0]
                                    4, 5, 6, .25, 50, 60, 70, 80, 9});  // items[1]
    scene::Dispatch dispatch;
    dispatch.program = made.compute("Mix", kMixed);
    dispatch.groups = std::array<std::uint64_t, 3>{2, 1, 1};
    made.scene.frame.add(dispatch);
    made.window();
    RenderOptions everything;
    everything.skip = false;
    auto scene = load(made, everything);
    ASSERT_TRUE(scene);
    draw(*scene);
    EXPECT_EQ(read(*scene, items, 99),
              (std::vector<double>{2, 2, 4, 6, .5, 10, 20, 40, 60, 8, 8, 10, 12, .25, 50, 60, 120, 140, 10}));
    EXPECT_EQ(scene->device().buffers().layout(items)->elements, 2U);
}

TEST_F(ModernCompute, FrameWritesBeginAsDeclaredInEveryFrame) {
    ComputeScene made(1, 1);
    const auto counter = made.buffer("Count", "uint", {}, {5});
    scene::Dispatch dispatch;
    dispatch.program = made.compute("Add", R"(
layout(local_size_x = 64) in;
layout(std430) buffer Count { uint count; };
void main() { atomicAdd(count, 1u); })");
    dispatch.groups = std::array<std::uint64_t, 3>{4, 1, 1};
    made.scene.frame.add(dispatch);
    made.window();
    made.fill(made.fragment("Show", R"(
layout(std430) readonly buffer Count { uint count; };
out vec4 fColor;
void main() { fColor = vec4(count == 261u ? 1. : 0.); })"));
    auto scene = load(made);
    ASSERT_TRUE(scene);
    for (int frame = 0; frame < 3; ++frame) {
        EXPECT_EQ(draw(*scene, frame), std::vector<std::byte>(3, std::byte{255})) << frame;
        EXPECT_EQ(read(*scene, counter, 1), std::vector<double>{261});
    }
    EXPECT_FALSE(scene->remembersFrames());
}

TEST_F(ModernCompute, AtomicCountersAreBuffers) {
    ComputeScene made(1, 1);
    const auto even = made.buffer("uEven", "uint", 1);
    scene::Dispatch dispatch;
    dispatch.program = made.compute("Count", R"(
layout(local_size_x = 8) in;
layout(binding = 3) uniform atomic_uint uEven;
void main() { if (gl_GlobalInvocationID.x % 2u == 0u) atomicCounterIncrement(uEven); })");
    dispatch.groups = scene::Over{std::array<std::uint64_t, 3>{40, 1, 1}};
    made.scene.frame.add(dispatch);
    made.window();
    EXPECT_EQ(resultOf(made, even, 1), std::vector<double>{20});
}

TEST_F(ModernCompute, CountsOfGroupsComeFromABuffer) {
    ComputeScene made(1, 1);
    const auto groups = made.buffer("groups", "uint", {}, {3, 2, 1});
    const auto count = made.buffer("Count", "uint", 1);
    scene::Dispatch dispatch;
    dispatch.program = made.compute("Count", R"(
layout(local_size_x = 5) in;
layout(std430) buffer Count { uint count; };
void main() { atomicAdd(count, 1u); })");
    dispatch.groups = scene::GroupsFrom{.first = {.buffer = {.buffer = groups}}};
    made.scene.frame.add(dispatch);
    made.window();
    EXPECT_EQ(resultOf(made, count, 1), std::vector<double>{30});
}

// ---- Errors

TEST_F(ModernCompute, RefusesWhatCannotRun) {
    ComputeScene unbound = sums(true);
    unbound.scene.buffers[scene::BufferIndex(2)].name = "other";
    RenderOptions everything;
    everything.skip = false;
    EXPECT_NE(refusal(unbound, 0, everything).find("storage block 'Sum' of program 'Add' has no buffer"),
              std::string::npos);

    ComputeScene large = sums(true);
    std::get<scene::Over>(large.scene.frame.dispatches[0].groups).what =
        std::array<std::uint64_t, 3>{1, std::uint64_t{1} << 40, 1};
    EXPECT_NE(refusal(large, 0, everything).find("1,099,511,627,776 groups along y; this driver allows"),
              std::string::npos);

    ComputeScene huge = sums(true);
    huge.scene.buffers[scene::BufferIndex(2)].count = std::uint64_t{1} << 62;
    EXPECT_NE(refusal(huge, 0, everything).find("memory-E17"), std::string::npos);

    ComputeScene unknown = sums(true);
    unknown.scene.buffers[scene::BufferIndex(2)].type = "Partcle";
    EXPECT_NE(refusal(unknown, 0, everything).find("no shader has a structure 'Partcle'"), std::string::npos);
}

TEST_F(ModernCompute, TwoLayoutsOfOneBufferAreAnError) {
    ComputeScene made = sums(true);
    const scene::Dispatch second = ComputeScene::over(made.compute("Other", R"(
layout(local_size_x = 1) in;
layout(std430) buffer Sum { vec3 sum[]; };
void main() { sum[0] = vec3(1); })"),
                                                      scene::BufferView{scene::BufferIndex(2)});
    made.scene.frame.add(second);
    RenderOptions everything;
    everything.skip = false;
    const std::string found = refusal(made, 0, everything);
    EXPECT_NE(found.find("lay out buffer 'Sum' differently"), std::string::npos) << found;
    EXPECT_NE(found.find("storage block 'Sum' (modern.glib:"), std::string::npos) << found;
}

TEST_F(ModernCompute, ABufferTooSmallForItsBlockIsAnError) {
    ComputeScene made(1, 1);
    made.buffer("Weights", "float", {}, {1, 2, 3});
    made.window();
    made.fill(made.fragment("Show", R"(
layout(std140) uniform Weights { float w[5]; };
out vec4 fColor;
void main() { fColor = vec4(w[4]); })"));
    EXPECT_NE(refusal(made).find("buffer 'Weights' has 3 numbers, but uniform block 'Weights' needs 5"),
              std::string::npos)
        << refusal(made);
}

TEST_F(ModernCompute, UniformBlocksReadBuffers) {
    ComputeScene made(1, 1);
    made.buffer("Weights", "float", {}, {.2, .4, .6, .8, 1});  // 16 bytes each, which nobody counted
    made.window();
    made.fill(made.fragment("Show", R"(
layout(std140) uniform Weights { float w[5]; };
out vec4 fColor;
void main() { fColor = vec4(w[1], w[2], w[4], 1); })"));
    auto scene = load(made);
    ASSERT_TRUE(scene);
    EXPECT_EQ(draw(*scene), (std::vector<std::byte>{std::byte{102}, std::byte{153}, std::byte{255}}));
}

}  // namespace
}  // namespace glibra::test
