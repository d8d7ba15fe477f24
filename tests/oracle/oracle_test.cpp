// Translated shaders against the same shaders unmodified in the driver's compatibility profile.

#include <gtest/gtest.h>

#include <iostream>

#include "both_pictures.h"

namespace glibra::oracle {
namespace {

/// Two colours of a picture may round to neighbouring bytes, no more.
constexpr int kTolerance = 1;

BothWays& bothWays() {
    static const std::unique_ptr<BothWays> shared = std::make_unique<BothWays>();
    return *shared;
}

std::vector<Case> allCases() {
    std::vector<Case> all;
    for (const auto& group : {casesOf110(), casesOf110Textures(), casesOf120(), casesOf130(), casesOf150(), casesOf330(),
                              casesOf400(), casesOfNames(), casesOfMacros(), casesOfStructures(), casesOfIdioms(), casesOfCollisions()})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

class TranslatedShaders : public testing::TestWithParam<Case> {
  public:
    static void TearDownTestSuite() {
        std::cout << "pictures equal in every byte: " << equal_ << " of " << drawn_ << "\n";
    }

  protected:
    static inline int drawn_ = 0;
    static inline int equal_ = 0;
};

TEST_P(TranslatedShaders, DrawWhatTheyDrawUnmodified) {
    try {
        const Pixels seen = bothWays().translated(GetParam());
        const Pixels expected = bothWays().asWritten(GetParam());
        const Content content = contentOf(expected);
        EXPECT_GE(content.colors, 2);
        EXPECT_GE(content.pixels, 100) << "too little to see";
        const Difference apart = difference(seen, expected);
        const std::size_t at = 4 * static_cast<std::size_t>(apart.y * seen.width + apart.x);
        const auto color = [at](const Pixels& picture) {
            std::string text;
            for (std::size_t i = 0; i < 4; ++i) text += " " + std::to_string(std::to_integer<int>(picture.data[at + i]));
            return text;
        };
        EXPECT_LE(apart.largest, kTolerance) << apart.pixels << " pixels differ; pixel " << apart.x << ", " << apart.y
                                             << " is" << color(seen) << " and should be" << color(expected);
        ++drawn_;
        if (apart.largest == 0) ++equal_;
    } catch (const std::exception& failure) {
        ADD_FAILURE() << failure.what();
    }
}

INSTANTIATE_TEST_SUITE_P(Dialects, TranslatedShaders, testing::ValuesIn(allCases()),
                         [](const testing::TestParamInfo<Case>& one) { return one.param.name; });

}  // namespace
}  // namespace glibra::oracle
