// Buffers, compute programs, steps, history, instances: what they write, against the same computed here.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "gpu/context/context.h"
#include "modern_by_hand.h"
#include "render/draw/simulation.h"
#include "render/load/device_scene.h"

namespace glibra::test {
namespace {

using base::TexelFormat;
using glsl::Stage;

/// A scene with buffers and compute programs.
class ComputeScene : public ModernScene {
  public:
    using ModernScene::ModernScene;

    scene::ProgramIndex compute(const std::string& name, const std::string& text) {
        return program(name, {{Stage::compute, "#version 430 core\n" + text}});
    }
    scene::BufferIndex buffer(const std::string& name, const std::string& type,
                              std::optional<std::uint64_t> count, std::vector<double> values = {}) {
        scene::Buffer made;
        made.name = name;
        made.type = type;
        made.count = count;
        made.values = std::move(values);
        made.place = {scene.path, 90 + static_cast<int>(scene.buffers.size()), 1};
        return scene.buffers.add(std::move(made));
    }
    static scene::Dispatch over(scene::ProgramIndex program, const scene::ObjectView& object) {
        scene::Dispatch made;
        made.program = program;
        made.groups = scene::Over{object};
        made.place = {"modern.glib", 70, 1};
        return made;
    }
    /// Three vertices without data that cover the window, with a fragment stage alone.
    scene::Draw& fill(scene::ProgramIndex program) {
        scene::Draw& draw = square(program);
        draw.shape = bare(geometry::Topology::triangles, 3);
        draw.word = "Fill";
        return draw;
    }
    scene::ShapeIndex bare(geometry::Topology topology, int vertices) {
        scene::Shape shape;
        shape.bare = topology;
        shape.numbers = {static_cast<double>(vertices)};
        return scene.shapes.add(std::move(shape));
    }
    scene::ProgramIndex fragment(const std::string& name, const std::string& text) {
        return program(name, {{Stage::fragment, "#version 430 core\n" + text}});
    }
    /// Binds objects to the tags of a dispatch.
    void bind(scene::Dispatch& dispatch,
              const std::vector<std::pair<std::string, scene::ObjectView>>& objects) {
        scene::UniformSet made;
        for (const auto& [tag, view] : objects) made.objects.push_back({tag, view, {1, 1}, {1, 1}});
        dispatch.uniforms = scene.uniformSets.add(std::move(made));
    }
};

class ModernCompute : public testing::Test {
  protected:
    void SetUp() override {
        if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    }
    /// The loaded scene; fails the test if there is none.
    std::optional<render::SceneRenderer> load(const ModernScene& modern, RenderOptions options = {}) {
        options.view = ViewPolicy::glman;
        render::InterpretedScene interpreted;
        interpreted.scene = modern.scene;
        Result<render::SceneRenderer> loaded =
            render::SceneRenderer::of(sharedContext(), std::move(interpreted), options, stats_);
        EXPECT_TRUE(loaded) << text(loaded.diagnostics);
        EXPECT_FALSE(hasError(loaded.diagnostics)) << text(loaded.diagnostics);
        return std::move(loaded.value);
    }
    std::vector<std::byte> draw(render::SceneRenderer& scene, double time = 0) {
        Result<image::Image> picture = scene.draw(time, stats_);
        EXPECT_TRUE(picture) << text(picture.diagnostics);
        return picture ? picture->data : std::vector<std::byte>();
    }
    /// The messages that keep a scene from being drawn.
    std::string refusal(const ModernScene& modern, double time = 0, RenderOptions options = {}) {
        options.view = ViewPolicy::glman;
        render::InterpretedScene interpreted;
        interpreted.scene = modern.scene;
        Result<render::SceneRenderer> loaded =
            render::SceneRenderer::of(sharedContext(), std::move(interpreted), options, stats_);
        if (!loaded) return text(loaded.diagnostics);
        const Result<image::Image> picture = loaded->draw(time, stats_);
        return picture ? "" : text(picture.diagnostics);
    }
    static std::vector<double> read(const render::SceneRenderer& scene, scene::BufferIndex buffer,
                                    std::uint64_t count) {
        return scene.device().buffers().read({buffer}, 0, count);
    }
    render::Stats stats_;
};

constexpr const char* kAdd = R"(
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
ComputeScene sums(bool isByName, const std::string& text = kAdd) {
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
    RenderOptions everything;
    everything.skip = false;
    for (const bool isByName : {false, true}) {
        auto scene = load(sums(isByName), everything);
        ASSERT_TRUE(scene);
        draw(*scene);
        EXPECT_EQ(read(*scene, scene::BufferIndex(2), 9), (std::vector<double>{40, 26, 96, 38, 101, 29}));
    }
}

TEST_F(ModernCompute, LayoutsOfTheDriverNeedNoCounting) {
    // Without a layout word the driver chooses one; some put each float into 16 bytes.
    std::string text = kAdd;
    for (std::size_t at; (at = text.find("layout(std430) ")) != std::string::npos;) text.erase(at, 15);
    RenderOptions everything;
    everything.skip = false;
    auto scene = load(sums(true, text), everything);
    ASSERT_TRUE(scene);
    draw(*scene);
    EXPECT_EQ(read(*scene, scene::BufferIndex(2), 6), (std::vector<double>{40, 26, 96, 38, 101, 29}));
}

TEST_F(ModernCompute, SkipsADispatchWhoseResultNobodyReads) {
    auto scene = load(sums(true));
    ASSERT_TRUE(scene);
    draw(*scene);
    const auto skipped = std::find_if(stats_.skipped.begin(), stats_.skipped.end(),
                                      [](const plan::Skipped& each) { return each.what == "dispatch"; });
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
    RenderOptions everything;
    everything.skip = false;
    auto scene = load(made, everything);
    ASSERT_TRUE(scene);
    draw(*scene);
    EXPECT_EQ(read(*scene, even, 1), std::vector<double>{20});
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
    dispatch.groups = scene::GroupsFrom{{groups}};
    made.scene.frame.add(dispatch);
    made.window();
    RenderOptions everything;
    everything.skip = false;
    auto scene = load(made, everything);
    ASSERT_TRUE(scene);
    draw(*scene);
    EXPECT_EQ(read(*scene, count, 1), std::vector<double>{30});
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
    EXPECT_NE(refusal(huge, 0, everything).find("memory-E04"), std::string::npos);

    ComputeScene unknown = sums(true);
    unknown.scene.buffers[scene::BufferIndex(2)].type = "Partcle";
    EXPECT_NE(refusal(unknown, 0, everything).find("no shader has a structure 'Partcle'"), std::string::npos);
}

TEST_F(ModernCompute, TwoLayoutsOfOneBufferAreAnError) {
    ComputeScene made = sums(true);
    scene::Dispatch second = ComputeScene::over(made.compute("Other", R"(
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

// ---- Steps

constexpr const char* kSeed = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(r8ui) writeonly uniform uimage2D uOut;
void main() {
    uvec2 at = gl_GlobalInvocationID.xy;
    uint h = at.x * 73856093u ^ at.y * 19349663u;
    h = (h ^ (h >> 13)) * 1274126177u;
    imageStore(uOut, ivec2(at), uvec4((h >> 16) & 1u));
}
)";
constexpr const char* kLife = R"(
layout(local_size_x = 8, local_size_y = 8) in;
uniform usampler2D uIn;
layout(r8ui) writeonly uniform uimage2D uOut;
void main() {
    ivec2 size = textureSize(uIn, 0);
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    uint n = 0u;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            if (x != 0 || y != 0) n += texelFetch(uIn, (at + ivec2(x, y) + size) % size, 0).r;
    uint own = texelFetch(uIn, at, 0).r;
    imageStore(uOut, at, uvec4(n == 3u || (n == 2u && own == 1u) ? 1u : 0u));
}
)";
constexpr int kSide = 64;

/// Conway's game of life on a torus of 64 x 64 cells.
ComputeScene life(double rate) {
    ComputeScene made(kSide, kSide);
    const auto cells = made.texture("life", TexelFormat::r8ui, kSide, kSide);
    made.scene.textures[cells].hasHistory = true;
    const scene::TextureView current{.texture = cells};
    const scene::TextureView previous{.texture = cells, .isPrevious = true};
    scene::OnceBlock once;
    scene::Dispatch seed = ComputeScene::over(made.compute("Seed", kSeed), current);
    made.bind(seed, {{"uOut", current}});
    once.nodes.add(seed);
    made.scene.once.push_back(std::move(once));
    scene::StepBlock step;
    step.rate = rate;
    step.place = {"modern.glib", 14, 1};
    scene::Dispatch generation = ComputeScene::over(made.compute("Generation", kLife), current);
    made.bind(generation, {{"uIn", previous}, {"uOut", current}});
    step.nodes.add(generation);
    made.scene.steps.push_back(std::move(step));
    made.window();
    scene::Draw& show = made.fill(made.fragment("Show", R"(
uniform usampler2D uLife;
out vec4 fColor;
void main() { fColor = vec4(texelFetch(uLife, ivec2(gl_FragCoord.xy), 0).r); })"));
    made.set(show, {}, {{"uLife", current}});
    return made;
}

/// The same with 64 cells per number, as sums of bits (the full adders of Hacker's Delight, 7-2).
class BitLife {
  public:
    BitLife() : rows_(kSide) {
        for (std::uint32_t y = 0; y < kSide; ++y)
            for (std::uint32_t x = 0; x < kSide; ++x) {
                std::uint32_t h = x * 73856093U ^ y * 19349663U;
                h = (h ^ (h >> 13U)) * 1274126177U;
                rows_[y] |= static_cast<std::uint64_t>((h >> 16U) & 1U) << x;
            }
    }
    void step() {
        std::vector<std::uint64_t> next(kSide);
        for (std::size_t y = 0; y < kSide; ++y) {
            const std::uint64_t up = rows_[(y + kSide - 1) % kSide];
            const std::uint64_t own = rows_[y];
            const std::uint64_t down = rows_[(y + 1) % kSide];
            std::uint64_t ones = 0, twos = 0, fours = 0;
            for (const std::uint64_t each :
                 {up, std::rotl(up, 1), std::rotr(up, 1), std::rotl(own, 1), std::rotr(own, 1), down,
                  std::rotl(down, 1), std::rotr(down, 1)}) {
                const std::uint64_t carry = ones & each;
                ones ^= each;
                fours |= twos & carry;
                twos ^= carry;
            }
            next[y] = twos & ~fours & (ones | own);
        }
        rows_ = std::move(next);
    }
    /// As the window shows it, top row first.
    [[nodiscard]] std::vector<std::byte> picture() const {
        std::vector<std::byte> bytes;
        for (std::size_t y = kSide; y-- > 0;)
            for (std::size_t x = 0; x < kSide; ++x)
                bytes.insert(bytes.end(), 3,
                             std::byte{(rows_[y] >> x & 1U) != 0 ? std::uint8_t{255} : std::uint8_t{0}});
        return bytes;
    }

  private:
    std::vector<std::uint64_t> rows_;
};

TEST_F(ModernCompute, LifeIsThatOfTheProcessorForAThousandGenerations) {
    auto scene = load(life(10));
    ASSERT_TRUE(scene);
    BitLife reference;
    EXPECT_EQ(draw(*scene, 0), reference.picture());
    for (int generation = 1; generation <= 1000; ++generation) {
        reference.step();
        if (generation % 50 == 0 || generation < 20) {
            ASSERT_EQ(draw(*scene, generation / 10.), reference.picture()) << generation;
        }
    }
}

TEST_F(ModernCompute, GoingBackAndStartingLaterGiveTheSame) {
    auto whole = load(life(10));
    auto part = load(life(10));
    ASSERT_TRUE(whole && part);
    const std::vector<std::byte> early = draw(*whole, 1.23);
    const std::vector<std::byte> late = draw(*whole, 7.5);
    EXPECT_NE(early, late);
    EXPECT_EQ(draw(*part, 7.5), late);
    EXPECT_EQ(draw(*part, 1.23), early);
    EXPECT_EQ(draw(*whole, 0), draw(*part, 0));
}

TEST_F(ModernCompute, MomentsCountSteps) {
    auto scene = load(life(10));
    ASSERT_TRUE(scene);
    EXPECT_FALSE(scene->remembersFrames());
    EXPECT_TRUE(scene->runsSteps());
    EXPECT_EQ(scene->momentOf(.31), scene->momentOf(.39));
    EXPECT_NE(scene->momentOf(.39), scene->momentOf(.4));
}

TEST_F(ModernCompute, TooManyStepsAreAnErrorUnlessAllowed) {
    const ComputeScene made = life(1000);
    const std::string found = refusal(made, 100.001);
    EXPECT_NE(found.find("modern.glib:14:1"), std::string::npos) << found;
    EXPECT_NE(found.find("needs 100,001 steps; the limit is 100,000 (--steps N allows more)"),
              std::string::npos)
        << found;
    RenderOptions few;
    few.steps = 5;
    EXPECT_EQ(refusal(made, .005, few), "");
    EXPECT_NE(refusal(made, .006, few), "");
    EXPECT_NE(refusal(life(1e9), 1e9).find("needs 1,000,000,000,000,000,000 steps"), std::string::npos);
}

TEST_F(ModernCompute, AFrameThatWritesWhatLastsNamesStep) {
    ComputeScene made = life(10);
    made.scene.frame.order.clear();
    scene::Dispatch again = made.scene.steps[0].nodes.dispatches[0];
    again.place = {"modern.glib", 33, 1};
    made.scene.frame.add(again);
    made.scene.frame.order.push_back({scene::NodeIndex::Kind::pass, 0});
    const std::string found = refusal(made);
    EXPECT_NE(found.find("modern.glib:33:1: error: 'life' lasts, because"), std::string::npos) << found;
    EXPECT_NE(found.find("write it in Step"), std::string::npos) << found;
}

TEST_F(ModernCompute, StepsThatNobodySeesDoNotRun) {
    ComputeScene made = life(10);
    made.scene.frame.passes.front().steps.clear();
    auto scene = load(made);
    ASSERT_TRUE(scene);
    draw(*scene, 5);
    for (const render::Stats::Count& each : stats_.counts) {
        EXPECT_FALSE(each.name == "dispatches") << each.value;
        EXPECT_FALSE(each.name == "steps") << each.value;
    }
}

constexpr const char* kFall = R"(
struct Particle { vec4 position; vec4 velocity; };
layout(local_size_x = 64) in;
layout(std430) buffer particles { Particle all[]; };
uniform float uDt;
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(all.length())) return;
    all[i].velocity.y -= 8. * uDt;
    all[i].position += all[i].velocity * uDt;
}
)";

TEST_F(ModernCompute, ParticlesFallAsTheClosedFormSays) {
    // y after n steps: y0 + v0 n dt - 8 dt^2 n (n + 1) / 2. All numbers are exact in floats.
    constexpr std::uint64_t kParticles = 200;
    constexpr double kDt = 1 / 64.;
    ComputeScene made(4, 4);
    std::vector<double> values;
    for (std::uint64_t i = 0; i < kParticles; ++i) {
        const auto x = static_cast<double>(i);
        values.insert(values.end(), {x, 100, 0, 1, .5, x / 8, 0, 0});
    }
    const auto particles = made.buffer("particles", "Particle", kParticles, values);
    scene::Program& fall = made.scene.programs[made.compute("Fall", kFall)];
    fall.uniforms.push_back({"uDt", glib::UniformForm::number, {kDt}, {1, 1}, {1, 1}});
    scene::StepBlock step;
    step.rate = 64;
    scene::Dispatch dispatch = ComputeScene::over(scene::ProgramIndex(0), scene::BufferView{particles});
    step.nodes.add(dispatch);
    made.scene.steps.push_back(std::move(step));
    made.window();
    RenderOptions everything;
    everything.skip = false;
    auto scene = load(made, everything);
    ASSERT_TRUE(scene);
    for (const double n : {0., 1., 7., 192.}) {
        draw(*scene, n * kDt);
        const std::vector<double> found = read(*scene, particles, kParticles * 8);
        ASSERT_EQ(found.size(), kParticles * 8);
        for (std::uint64_t i = 0; i < kParticles; ++i) {
            const auto x = static_cast<double>(i);
            EXPECT_EQ(found[i * 8], x + .5 * n * kDt);
            EXPECT_EQ(found[i * 8 + 1], 100 + x / 8 * n * kDt - 8 * kDt * kDt * n * (n + 1) / 2) << i;
        }
    }
}

TEST(Steps, AreCountedExactly) {
    EXPECT_EQ(render::stepsAt(0, 60), 0);
    EXPECT_EQ(render::stepsAt(-1, 60), 0);
    EXPECT_EQ(render::stepsAt(1e6, .1), 100'000);
    EXPECT_EQ(render::stepsAt(1e6 - 1e-3, .1), 99'999);
    EXPECT_EQ(render::stepsAt(1e6, 1 / 3.), 333'333);
    EXPECT_EQ(render::stepsAt(999'999, 1 / 3.), 333'333);
    EXPECT_EQ(render::stepsAt(1e6, .0001), 100);
    for (int frame = 0; frame < 100'000; ++frame) {
        EXPECT_EQ(render::stepsAt(frame / 60., 60), frame);
        EXPECT_EQ(render::stepsAt(frame / 30., 10), frame / 3);
    }
    EXPECT_EQ(render::stepsAt(1e300, 1e300), std::int64_t{1} << 62);
    EXPECT_EQ(render::stepsAt(std::nan(""), 1), 0);
}

TEST(Steps, OfSeveralBlocksMergeByTime) {
    const std::vector<double> rates{20, 10, 15};
    std::string order;
    render::inOrderOfTime(rates, std::vector<std::int64_t>{0, 0, 0}, std::vector<std::int64_t>{4, 2, 3},
                          [&](render::StepNumber step) {
                              order += std::to_string(step.block) + ":" + std::to_string(step.tick) + " ";
                              return true;
                          });
    // Times: 0 at .05 .1 .15 .2; 1 at .1 .2; 2 at .0667 .1333 .2.
    EXPECT_EQ(order, "0:0 2:0 0:1 1:0 2:1 0:2 0:3 1:1 2:2 ");
}

TEST(Steps, GoOnOnlyInTheOrderOfTime) {
    const std::vector<double> rates{20, 10};
    const auto canGoOn = [&](std::vector<std::int64_t> done, std::vector<std::int64_t> to) {
        return render::canGoOn(rates, done, to);
    };
    EXPECT_TRUE(canGoOn({0, 0}, {4, 2}));
    EXPECT_TRUE(canGoOn({2, 1}, {4, 2}));
    EXPECT_TRUE(canGoOn({2, 1}, {2, 1}));
    EXPECT_FALSE(canGoOn({2, 1}, {1, 1}));
    EXPECT_FALSE(canGoOn({1, 1}, {4, 2}));  // 0:1 ties with 1:0, and comes first
}

// ---- Draws

constexpr const char* kRow = R"(#version 430 core
in vec4 aVertex;
uniform int uFirst;
out vec4 vColor;
void main() {
    int i = uFirst + gl_InstanceID;
    vColor = vec4(float(i % 4) / 3., float(i / 4) / 3., .5, .5);
    gl_Position = vec4(aVertex.xy * .1 + vec2(i % 4, i / 4) * .3 - .5, 0, 1);
}
)";
constexpr const char* kPlain = R"(#version 430 core
in vec4 vColor;
out vec4 fColor;
void main() { fColor = vColor; }
)";

/// Sixteen overlapping squares, drawn at once or one by one.
ComputeScene squares(bool isInstanced) {
    ComputeScene made(64, 64);
    const auto program = made.program("Row", {{Stage::vertex, kRow}, {Stage::fragment, kPlain}});
    made.window();
    for (int i = 0; i < (isInstanced ? 1 : 16); ++i) {
        scene::Draw& draw = made.square(program, 0, 2);
        draw.instances = isInstanced ? 16 : 1;
        draw.raster.blend.fill(base::kBlendOver);
        made.set(draw, {{"uFirst", {static_cast<double>(i)}}});
    }
    return made;
}

TEST_F(ModernCompute, InstancesAreTheSameAsALoop) {
    auto instanced = load(squares(true));
    auto looped = load(squares(false));
    ASSERT_TRUE(instanced && looped);
    const std::vector<std::byte> one = draw(*instanced);
    EXPECT_EQ(one, draw(*looped));
    EXPECT_GT(std::count(one.begin(), one.end(), std::byte{0}), 0);
    EXPECT_GT(std::count_if(one.begin(), one.end(), [](std::byte each) { return each != std::byte{0}; }),
              2000);
}

TEST_F(ModernCompute, CountsOfDrawsComeFromBuffers) {
    auto given = load(squares(true));
    ComputeScene made = squares(true);
    scene::Draw& draw = std::get<scene::Draw>(made.scene.frame.passes.back().steps.back());
    draw.instances = 1;
    draw.instancesFrom.buffer = made.buffer("count", "uint", {}, {16});
    auto indirect = load(made);
    ASSERT_TRUE(given && indirect);
    EXPECT_EQ(this->draw(*given), this->draw(*indirect));
}

TEST_F(ModernCompute, VerticesNeedNoData) {
    constexpr const char* kVertices = R"(#version 430 core
out vec4 vColor;
void main() {
    vColor = vec4(1, .2, .4, 1);
    gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1);
}
)";
    for (const bool isFromBuffer : {false, true}) {
        ComputeScene made(8, 8);
        const auto program = made.program("Cover", {{Stage::vertex, kVertices}, {Stage::fragment, kPlain}});
        made.window();
        scene::Draw& draw = made.square(program);
        draw.shape = made.bare(geometry::Topology::triangles, isFromBuffer ? 0 : 3);
        if (isFromBuffer) draw.verticesFrom.buffer = made.buffer("count", "uint", {}, {3});
        auto scene = load(made);
        ASSERT_TRUE(scene);
        const std::vector<std::byte> bytes = this->draw(*scene);
        for (std::size_t i = 0; i < bytes.size(); i += 3) {
            ASSERT_EQ(bytes[i], std::byte{255});
            ASSERT_EQ(bytes[i + 1], std::byte{51});
            ASSERT_EQ(bytes[i + 2], std::byte{102});
        }
    }
}

constexpr const char* kOffset = R"(#version 430 core
in vec4 aVertex;
in vec2 iOffset;
in mat2 iTurn;
in vec4 iColor;
out vec4 vColor;
void main() {
    vColor = iColor;
    gl_Position = vec4(iTurn * aVertex.xy * .1 + iOffset, 0, 1);
}
)";

TEST_F(ModernCompute, AttributesComeFromBuffersAndNumbers) {
    // The same squares with attributes per instance, and one draw each with constant attributes.
    const std::vector<std::array<double, 10>> rows{{-.5, -.5, 1, 0, 0, 1, 1, 0, 0, 1},
                                                   {.5, -.25, .8, .6, -.6, .8, 0, 1, 0, 1},
                                                   {0, .5, .6, .8, -.8, .6, 0, 0, 1, 1}};
    const auto picture = [&](bool isInstanced) {
        ComputeScene made(64, 64);
        const auto program = made.program("Place", {{Stage::vertex, kOffset}, {Stage::fragment, kPlain}});
        std::vector<double> offsets, turns, colors;
        for (const auto& row : rows) {
            offsets.insert(offsets.end(), row.begin(), row.begin() + 2);
            turns.insert(turns.end(), row.begin() + 2, row.begin() + 6);
            colors.insert(colors.end(), row.begin() + 6, row.end());
        }
        const scene::BufferView offset{made.buffer("offsets", "vec2", {}, offsets)};
        const scene::BufferView turn{made.buffer("turns", "mat2", {}, turns)};
        const scene::BufferView color{made.buffer("colors", "vec4", {}, colors)};
        made.window();
        for (std::size_t i = 0; i < (isInstanced ? 1 : rows.size()); ++i) {
            scene::Draw& draw = made.square(program, 0, 2);
            scene::AttributeSet set;
            if (isInstanced) {
                draw.instances = 3;
                set.bindings = {
                    {"iOffset", offset, true, {}}, {"iTurn", turn, true, {}}, {"iColor", color, true, {}}};
            } else {
                const auto& row = rows[i];
                set.bindings = {{"iOffset", std::vector<double>(row.begin(), row.begin() + 2), false, {}},
                                {"iTurn", turn, true, {}},
                                {"iColor", std::vector<double>(row.begin() + 6, row.end()), false, {}}};
                if (i != 0) continue;  // a matrix cannot be a constant attribute
            }
            draw.attributes = made.scene.attributeSets.add(std::move(set));
        }
        auto scene = load(made);
        return scene ? draw(*scene) : std::vector<std::byte>();
    };
    const std::vector<std::byte> instanced = picture(true);
    ASSERT_FALSE(instanced.empty());
    const std::vector<std::byte> first = picture(false);
    std::size_t red = 0, green = 0, blue = 0, redAlone = 0;
    for (std::size_t i = 0; i < instanced.size(); i += 3) {
        red += instanced[i] != std::byte{0};
        green += instanced[i + 1] != std::byte{0};
        blue += instanced[i + 2] != std::byte{0};
        redAlone += first[i] != std::byte{0};
    }
    EXPECT_EQ(red, redAlone);
    EXPECT_GT(red, 100U);
    // Squares with sides of 12.8 pixels, of which pixels at the border count or not.
    for (const std::size_t each : {red, green, blue}) EXPECT_NEAR(static_cast<double>(each), 12.8 * 12.8, 26);
}

}  // namespace
}  // namespace glibra::test
