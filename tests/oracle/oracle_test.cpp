// Compares translated shaders with the same shaders, unmodified, in the driver's compatibility profile.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <stdexcept>

#include "both_pictures.h"

namespace glibra::oracle {

/// Prints the name of a case in failure messages. gtest finds the function by this name.
// NOLINTNEXTLINE(readability-identifier-naming)
static void PrintTo(const Case& each, std::ostream* stream) {
    *stream << each.name;
}

namespace {

/// A component may round to a neighbouring byte.
constexpr int kTolerance = 1;
/// A picture with fewer pixels would prove nothing.
constexpr int kFewestPixels = 100;

BothWays& bothWays() {
    static const std::unique_ptr<BothWays> shared = std::make_unique<BothWays>();
    return *shared;
}

std::vector<Case> allCases() {
    std::vector<Case> all;
    for (const auto& group :
         {casesOf110(), casesOf110State(), casesOf110Textures(), casesOf120(), casesOf130(),
          casesOfGeometryShader4(), casesOf150(), casesOf330(), casesOf400(), casesOfNames(), casesOfMacros(),
          casesOfStructures(), casesOfIdioms(), casesOfCollisions(), casesOfExtensions()})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

Case caseOf(std::string_view name) {
    const std::vector<Case> all = allCases();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Case& each) { return each.name == name; });
    if (found == all.end()) throw std::runtime_error("no such case");
    return *found;
}

/// The pixel's components as text.
std::string color(const Pixels& picture, int x, int y) {
    const auto at = 4 * static_cast<std::size_t>(y * picture.width + x);
    std::string text;
    for (std::size_t i = at; i < at + 4; ++i)
        text += " " + std::to_string(std::to_integer<int>(picture.data[i]));
    return text;
}

class TranslatedShaders : public testing::TestWithParam<Case> {
  public:
    static void TearDownTestSuite() {
        std::cout << "pictures equal in every byte: " << equal << " of " << drawn << "\n";
    }

  protected:
    static inline int drawn = 0;
    static inline int equal = 0;
};

TEST_P(TranslatedShaders, DrawWhatTheyDrawUnmodified) {
    try {
        const Pixels seen = bothWays().translated(GetParam());
        const Pixels expected = bothWays().asWritten(GetParam());
        const Content content = contentOf(expected);
        EXPECT_GE(content.colors, 2) << "the picture has only one colour";
        EXPECT_GE(content.pixels, kFewestPixels) << "too few pixels drawn";
        const Difference apart = difference(seen, expected);
        EXPECT_LE(apart.largest, kTolerance)
            << apart.pixels << " pixels differ; pixel " << apart.x << ", " << apart.y << " is"
            << color(seen, apart.x, apart.y) << " and should be" << color(expected, apart.x, apart.y);
        ++drawn;
        if (apart.largest == 0) ++equal;
    } catch (const std::exception& failure) {
        ADD_FAILURE() << failure.what();
    }
}

INSTANTIATE_TEST_SUITE_P(Dialects, TranslatedShaders, testing::ValuesIn(allCases()),
                         [](const testing::TestParamInfo<Case>& one) { return one.param.name; });

TEST(Oracle, NoticesAnotherUniformValue) {
    const Case each = caseOf("v110_uniforms");
    Case other = each;
    const std::string given = "uSteps <1 5 9>";
    other.tags.replace(other.tags.find(given), given.size(), "uSteps <1 6 9>");
    EXPECT_GT(difference(bothWays().translated(each), bothWays().asWritten(other)).largest, kTolerance);
}

/// The effect of a wrong translation on a case: `from` in a stage or in the draws becomes `to`.
struct Mistake {
    const char* what;
    const char* name;
    const char* from;
    const char* to;
};

TEST(Oracle, NoticesEveryMistakeOfATranslation) {
    static constexpr std::array<Mistake, 12> kMistakes{{
        {"normal matrix forgotten", "v110_attributes_and_varyings", "gl_NormalMatrix * gl_Normal",
         "gl_Normal"},
        {"colour not clamped", "v110_front_color_is_clamped_where_it_leaves_the_vertex_stage",
         "gl_FrontColor = gl_FrontColor * .5", "gl_FrontColor = clamp(gl_FrontColor, 0., 1.) * .5"},
        {"early return forgotten", "v110_front_color_is_clamped_where_it_leaves_the_vertex_stage", "return;",
         ";"},
        {"back colour ignored", "v110_back_color_on_back_faces", "gl_BackColor = vec4(0.,",
         "gl_BackColor = vec4(1.,"},
        {"wrong texture coordinates", "v110_texture_coordinates", "gl_TexCoord[3].stp / gl_TexCoord[3].q",
         "gl_TexCoord[0].stp / gl_TexCoord[0].q"},
        {"Flat ignored", "v110_flat_colors", "Flat\n", "Smooth\n"},
        {"targets exchanged", "v110_frag_data_goes_to_its_own_target",
         "gl_FragData[1] = vec4(fract(2. * vPoint), 1.)", "gl_FragData[1] = vec4(.5 + .5 * vPoint.zyx, .5)"},
        {"inverse for transpose", "v110_matrices_and_their_relatives", "gl_ModelViewMatrixTranspose",
         "gl_ModelViewMatrixInverse"},
        {"user's function ignored", "names_of_built_in_functions_of_the_same_version",
         "float mod(float a, float b) {", "float notMod(float a, float b) {"},
        {"noise of another period", "v110_texture3D_noise", "uFrequency * vPoint",
         "2. * uFrequency * vPoint"},
        {"bias taken for a coordinate", "v110_texture2DProj", "vec3(vPoint.xy, 2.)", "vec3(vPoint.xy, 1.)"},
        {"material forgotten", "v110_light_sources", "gl_FrontLightProduct[0].diffuse",
         "gl_LightSource[0].diffuse"},
    }};
    for (const Mistake& mistake : kMistakes) {
        const Case each = caseOf(mistake.name);
        Case wrong = each;
        bool found = false;
        for (std::string* text : {&wrong.stages.vertex, &wrong.stages.fragment, &wrong.draws})
            if (const std::size_t at = text->find(mistake.from); at != std::string::npos) {
                text->replace(at, std::string_view(mistake.from).size(), mistake.to);
                found = true;
            }
        ASSERT_TRUE(found) << mistake.what;
        try {
            const Difference apart = difference(bothWays().translated(each), bothWays().asWritten(wrong));
            EXPECT_GT(apart.largest, kTolerance) << mistake.what;
        } catch (const std::exception& failure) {
            ADD_FAILURE() << mistake.what << ": " << failure.what();
        }
    }
}

TEST(Oracle, MeasuresDifferences) {
    const Pixels a{2, 1, std::vector<std::byte>(8)};
    Pixels b = a;
    EXPECT_EQ(difference(a, b).largest, 0);
    EXPECT_EQ(contentOf(a).colors, 1);
    b.data[6] = std::byte{7};
    const Difference apart = difference(a, b);
    EXPECT_EQ(apart.largest, 7);
    EXPECT_EQ(apart.pixels, 1);
    EXPECT_EQ(apart.x, 1);
    EXPECT_EQ(contentOf(b).pixels, 1);
}

}  // namespace
}  // namespace glibra::oracle
