// Steps and history: simulations against the same computed here.

#include <bit>
#include <cmath>

#include "modern_compute.h"
#include "render/simulation/simulation.h"

namespace glibra::test {
namespace {

using base::TexelFormat;

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
constexpr int kLifeSide = 64;

/// Conway's game of life on a torus of 64 x 64 cells.
ComputeScene life(double rate) {
    ComputeScene made(kLifeSide, kLifeSide);
    const auto cells = made.texture("life", TexelFormat::r8ui, kLifeSide, kLifeSide);
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
    BitLife() : rows_(kLifeSide) {
        for (std::uint32_t y = 0; y < kLifeSide; ++y)
            for (std::uint32_t x = 0; x < kLifeSide; ++x) {
                std::uint32_t h = x * 73856093U ^ y * 19349663U;
                h = (h ^ (h >> 13U)) * 1274126177U;
                rows_[y] |= static_cast<std::uint64_t>((h >> 16U) & 1U) << x;
            }
    }
    void step() {
        std::vector<std::uint64_t> next(kLifeSide);
        for (std::size_t y = 0; y < kLifeSide; ++y) {
            const std::uint64_t up = rows_[(y + kLifeSide - 1) % kLifeSide];
            const std::uint64_t own = rows_[y];
            const std::uint64_t down = rows_[(y + 1) % kLifeSide];
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
        for (std::size_t y = kLifeSide; y-- > 0;)
            for (std::size_t x = 0; x < kLifeSide; ++x)
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
        ASSERT_EQ(draw(*scene, generation / 10.), reference.picture()) << generation;
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
    const scene::Dispatch dispatch = ComputeScene::over(scene::ProgramIndex(0), scene::BufferView{particles});
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

}  // namespace
}  // namespace glibra::test
