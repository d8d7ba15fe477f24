// The choice of noise textures for whole scenes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "budget_case.h"

namespace glibra::budget {
namespace {

/// A scene whose program samples Noise3.
class NoiseBudget : public Budget {
  public:
    explicit NoiseBudget(const std::string& statement, double bound)
        : Budget(kEye + statement + kProgram + "Sphere\n") {
        request.maxError = bound;
        addSampler("Noise3", scene::TextureTarget::texture3D, "sampler3D");
    }
    [[nodiscard]] NoiseFormat chosen() {
        choose();
        const auto& noise = std::get<scene::NoiseSource>(scene.textures.at(1).source);
        return {noise.size, noise.texels};
    }
};
constexpr auto kBytes = scene::NoiseTexels::bytes, kShorts = scene::NoiseTexels::shorts;

TEST(Choose, ChoosesTheNoiseThatTheSceneLeavesOpen) {
    // About 250 pixels per unit; 64 texels are off by .0082 of a period, bytes by .0017.
    EXPECT_EQ(NoiseBudget("", 4).chosen(), (NoiseFormat{64, kBytes}));
    EXPECT_EQ(NoiseBudget("", .7).chosen(), (NoiseFormat{128, kBytes}));
    EXPECT_EQ(NoiseBudget("", .25).chosen(), (NoiseFormat{192, kShorts}));
    EXPECT_EQ(NoiseBudget("", 10).chosen(), (NoiseFormat{32, kBytes}));
    EXPECT_EQ(NoiseBudget("Noise3D 100\n", .25).chosen(), (NoiseFormat{100, kBytes}));
    NoiseBudget free("Noise3D 100\n", .25);
    free.request.overrideCounts = true;
    EXPECT_EQ(free.chosen(), (NoiseFormat{192, kShorts}));
    EXPECT_NE(free.decision("Noise3D").find("192 texels per side with 16 bits in place of 100"),
              std::string::npos);
}

/// Two pictures of a slope of 1/100 per pixel that moves by that many pixels.
ContourShifts slopes(double shift, float contrast = 1) {
    constexpr int kSide = 64;
    const auto picture = [&](double by) {
        std::vector<float> values;
        for (int i = 0; i < kSide * kSide; ++i)
            values.insert(values.end(), 3, contrast * static_cast<float>(.1 + .01 * (i % kSide - by)));
        image::Image made{kSide, kSide, 3, image::Component::f32, {}};
        made.data.resize(values.size() * sizeof(float));
        std::memcpy(made.data.data(), values.data(), made.data.size());
        return made;
    };
    return {picture(0), picture(shift)};
}

TEST(Choose, TakesTheNoiseFromPicturesWhereTheyTellIt) {
    const auto chosenFor = [](const std::optional<ContourShifts>& shifts, double bound) {
        NoiseBudget budget("", bound);
        int asked = 0;
        budget.request.contourShift = [&](const Choice& from, const Choice& to) {
            ++asked;
            EXPECT_EQ(from.noise.size(), 1U);
            EXPECT_GT(to.noise.front().format.size, from.noise.front().format.size);
            EXPECT_EQ(to.noise.front().texture, scene::TextureIndex(1));
            return shifts;
        };
        const NoiseFormat chosen = budget.chosen();
        EXPECT_EQ(asked, 1);
        return chosen;
    };
    // A shift of 10 pixels is that of a period of 7690 pixels.
    const auto far = slopes(10);
    EXPECT_EQ(chosenFor(slopes(0), .25), (NoiseFormat{32, kBytes}));
    EXPECT_EQ(chosenFor(far, 70), (NoiseFormat{64, kBytes}));
    EXPECT_EQ(chosenFor(far, 21), (NoiseFormat{128, kBytes}));
    EXPECT_EQ(chosenFor(far, 16), (NoiseFormat{128, kShorts}));
    // Finer noise would change no value visibly.
    EXPECT_EQ(chosenFor(far, 4), (NoiseFormat{192, kShorts}));
    // The same, but hardly visible.
    EXPECT_EQ(chosenFor(slopes(10, .05F), 4), (NoiseFormat{64, kBytes}));
    EXPECT_EQ(chosenFor(std::nullopt, .25), (NoiseFormat{192, kShorts}));
}

TEST(Choose, SaysWhatNoiseCannotKeep) {
    NoiseBudget stated("Noise3D 40\n", .25);
    stated.choose();
    ASSERT_EQ(stated.choice.diagnostics.size(), 1U);
    EXPECT_EQ(stated.choice.diagnostics[0].id, "draw-N03");
    EXPECT_NE(stated.choice.diagnostics[0].text.find("Noise3D with 40 texels"), std::string::npos);
    // Sizes that a scene states are also judged by pictures.
    NoiseBudget stretched("Noise3D 100\n", 4);
    stretched.choose();
    EXPECT_TRUE(stretched.choice.diagnostics.empty());
    NoiseBudget seen("Noise3D 100\n", 4);
    seen.request.contourShift = [](const auto&, const auto&) { return slopes(10); };
    seen.choose();
    ASSERT_EQ(seen.choice.diagnostics.size(), 1U);
    EXPECT_EQ(seen.choice.diagnostics[0].id, "draw-N03");
    NoiseBudget beyond("", .001);
    beyond.request.areSamplesFree = false;
    beyond.request.contourShift = [](const auto&, const auto&) { return slopes(40); };
    beyond.choose();
    const auto& all = beyond.choice.diagnostics;
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Diagnostic& each) {
        return each.id == "draw-W07" && each.text.find("Noise3D with 256 texels") != std::string::npos;
    }));
}

}  // namespace
}  // namespace glibra::budget
