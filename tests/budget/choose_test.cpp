// The choice for whole scenes, without GL: programs are described by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "budget/least_counts.h"
#include "budget_case.h"
#include "glib/statement_table.h"

namespace glibra::budget {
namespace {

TEST(Choose, GivesASphereTheLeastCountsForItsPixels) {
    Budget budget(kEye + "Sphere\n");
    budget.choose();
    // 300 cot(25 degrees) pixels per unit at distance 1, including sideways views; the nearest point of the
    // sphere is at distance 3.
    const double straight = 300 / std::tan(25 * std::numbers::pi / 180) / 3;
    const auto& chosen = budget.numbers(0);
    const double off = surfaceModel(glib::commandOf("Sphere"))->deviation(chosen, Fidelity::shape);
    EXPECT_LE(off * straight, .25);
    EXPECT_GE(off * straight, .25 / 1.3);
    EXPECT_EQ(budget.choice.diagnostics.size(), 0U);
    EXPECT_EQ(budget.replaced, std::vector{scene::ShapeIndex(0)});
}

TEST(Choose, CountsFallWithTheRootOfTheBound) {
    std::vector<double> slices;
    for (const double bound : {.05, .2, .8}) {
        Budget budget(kEye + "Sphere\n");
        budget.request.maxError = bound;
        budget.choose();
        slices.push_back(budget.numbers(0)[1]);
    }
    EXPECT_NEAR(slices[0] / slices[1], 2, .1);
    EXPECT_NEAR(slices[1] / slices[2], 2, .15);
}

TEST(Choose, LeavesStatedNumbersAsTheyAre) {
    Budget budget(kEye + "Sphere 1 20 10\nTorus 1 .5 9 9\nNoise3D 32\n");
    const scene::Scene before = budget.scene;
    const Choice& choice = budget.choose();
    EXPECT_TRUE(choice.shapes.empty());
    EXPECT_EQ(budget.numbers(0), (std::vector<double>{1, 20, 10}));
    ASSERT_EQ(choice.diagnostics.size(), 1U);
    EXPECT_EQ(choice.diagnostics[0].id, "draw-N03");
    EXPECT_EQ(choice.diagnostics[0].place.line, 3);  // the torus is worse
    EXPECT_NE(choice.diagnostics[0].text.find("the same holds for 1 more"), std::string::npos);
}

TEST(Choose, ChoosesTheRestOfWhatIsStatedInPart) {
    Budget budget(kEye + "Sphere 1 80\n");
    budget.choose();
    EXPECT_EQ(budget.numbers(0)[1], 80);
    const auto off = [&](double stacks) {
        return surfaceModel(glib::commandOf("Sphere"))
            ->deviation(std::vector{1., 80., stacks}, Fidelity::shape);
    };
    Budget open(kEye + "Sphere\n");
    open.choose();
    const double allowed =
        surfaceModel(glib::commandOf("Sphere"))->deviation(open.numbers(0), Fidelity::shape);
    EXPECT_LE(off(budget.numbers(0)[2]), allowed * 1.02);
    EXPECT_GT(off(budget.numbers(0)[2] - 1), allowed * .98);
}

TEST(Choose, ChoosesForStatedNumbersWhenAsked) {
    Budget stated(kEye + "Sphere 1 20 10\n"), open(kEye + "Sphere 1\n");
    stated.request.overrideCounts = true;
    stated.choose();
    open.choose();
    EXPECT_EQ(stated.numbers(0), open.numbers(0));
    EXPECT_TRUE(stated.choice.diagnostics.empty());
}

TEST(Choose, NeverCoarsensWhatAProgramMoves) {
    Budget budget(kEye + kProgram + "Sphere\nTranslate 0 0 3.8\nSphere .1\n");
    budget.program.facts.placement = glsl::Placement::unknown;
    budget.request.maxError = 5;
    budget.choose();
    EXPECT_EQ(budget.numbers(0), (std::vector<double>{1, 60, 60}));
    budget.request.maxError = .05;
    budget.choose();
    EXPECT_GT(budget.numbers(0)[1], 60);
    EXPECT_NE(budget.decision("Sphere").find("no bound"), std::string::npos);
}

TEST(Choose, KeepsEnoughVerticesForLightComputedAtThem) {
    Budget budget(kEye + kProgram + "Sphere\nCylinder\nQuadXY\n");
    budget.request.maxError = 50;
    budget.choose();
    EXPECT_EQ(budget.numbers(0), (std::vector<double>{1, 36, 18}));
    EXPECT_EQ(budget.numbers(1), (std::vector<double>{1, 1, 36, 20}));
    EXPECT_EQ(budget.numbers(2), (std::vector<double>{0, 1, 4, 4}));
    // One colour needs no more than the shape.
    Budget plain(kEye + "Sphere\nCylinder\nQuadXY\n");
    plain.request.maxError = 50;
    plain.choose();
    EXPECT_LT(plain.numbers(0)[1], 12);
    EXPECT_EQ(plain.numbers(1)[3], 1);
    EXPECT_EQ(plain.numbers(2), (std::vector<double>{0, 1, 1, 1}));
}

TEST(Choose, IsFinerForAProgramThatReflects) {
    Budget plain(kEye + kProgram + "Sphere\n"), mirror(kEye + kProgram + "Sphere\n");
    for (Budget* each : {&plain, &mirror}) {
        each->request.maxError = 50;
        each->program.inputs.push_back({"aNormal", 1});
    }
    mirror.program.facts.stages[1].facts.magnifiesNormals = true;
    plain.choose();
    mirror.choose();
    EXPECT_EQ(plain.numbers(0), (std::vector<double>{1, 36, 18}));
    EXPECT_EQ(mirror.numbers(0), (std::vector<double>{1, 72, 36}));
}

/// A scene whose program computes light at the vertices, which is off by 8/255 with `slices` slices.
class LitBudget : public Budget {
  public:
    LitBudget(const std::string& sphere, double slices) : Budget(kEye + kProgram + sphere) {
        program.facts.stages[0].facts.callsFunctions = true;
        request.maxError = 5;
        request.contourShift = [this, slices](const Choice& from, const Choice& to) {
            ++asked;
            EXPECT_TRUE(from.noise.empty());
            EXPECT_EQ(from.samples, 4);
            const auto lit = [&](const Choice& made) {
                const double n = made.shapes.front().numbers[1];
                return brightened(8. / 255 * slices * slices / (n * n));
            };
            return ContourShifts(lit(from), lit(to));
        };
    }
    int asked = 0;

  private:
    static image::Image brightened(double light) {
        constexpr int kSide = 64;
        const std::vector<float> values(std::size_t{3} * kSide * kSide, static_cast<float>(.2 + light));
        image::Image made{kSide, kSide, 3, image::Component::f32, {}};
        made.data.resize(values.size() * sizeof(float));
        std::memcpy(made.data.data(), values.data(), made.data.size());
        return made;
    }
};

TEST(Choose, MeasuresWhatIsComputedAtTheVertices) {
    LitBudget smooth("Sphere\n", 10), coarse("Sphere\n", 80), stated("Sphere 1 60 60\n", 200);
    smooth.choose();
    EXPECT_EQ(smooth.numbers(0), (std::vector<double>{1, 36, 18}));
    EXPECT_EQ(smooth.asked, 1);
    coarse.choose();
    EXPECT_GE(coarse.numbers(0)[1], 80);
    EXPECT_TRUE(coarse.choice.diagnostics.empty());
    EXPECT_NE(coarse.decision("Sphere").find("values computed at the vertices"), std::string::npos);
    stated.choose();
    EXPECT_EQ(stated.numbers(0), (std::vector<double>{1, 60, 60}));
    ASSERT_EQ(stated.choice.diagnostics.size(), 1U);
    EXPECT_EQ(stated.choice.diagnostics[0].id, "draw-N03");
    EXPECT_NE(stated.choice.diagnostics[0].text.find("of 1000 pixels"), std::string::npos);
}

TEST(Choose, SaysWhereFinerMeshesDoNotHelp) {
    LitBudget chaotic("Sphere\n", 36);
    chaotic.request.contourShift = [](const Choice& from, const Choice&) {
        const std::vector<float> bright(std::size_t{3} * 64 * 64, .5F + .1F / float(from.shapes.size()));
        image::Image one{64, 64, 3, image::Component::f32, {}}, other = one;
        one.data.resize(bright.size() * sizeof(float));
        other.data.resize(bright.size() * sizeof(float));
        std::memcpy(one.data.data(), bright.data(), one.data.size());
        return ContourShifts(one, other);
    };
    chaotic.choose();
    ASSERT_EQ(chaotic.choice.diagnostics.size(), 1U);
    EXPECT_EQ(chaotic.choice.diagnostics[0].id, "draw-W07");
    EXPECT_NE(chaotic.choice.diagnostics[0].text.find("finer counts do not help"), std::string::npos);
}

TEST(Choose, MeasuresNothingOfProgramsThatOnlyPlace) {
    Budget budget(kEye + kProgram + "Sphere\n");
    budget.request.contourShift = [](const Choice&, const Choice&) {
        ADD_FAILURE() << "no picture is needed";
        return std::optional<ContourShifts>();
    };
    budget.choose();
}

TEST(Choose, IsFinerForAProgramThatReadsTextureCoordinates) {
    Budget plain(kEye + kProgram + "Sphere\n"), textured(kEye + kProgram + "Sphere\n");
    textured.program.inputs.push_back({"aTexCoord0", 1});
    plain.choose();
    textured.choose();
    EXPECT_GT(textured.numbers(0)[1] * textured.numbers(0)[2],
              1.5 * plain.numbers(0)[1] * plain.numbers(0)[2]);
}

TEST(Choose, KeepsWhatShowsItsTriangles) {
    const auto kept = [](const std::function<void(Budget&)>& change, const std::string& statements = {}) {
        Budget budget(kEye + kProgram + statements + "Sphere\n");
        change(budget);
        budget.choose();
        EXPECT_EQ(budget.numbers(0), (std::vector<double>{1, 60, 60}));
        return budget.decision("Sphere");
    };
    EXPECT_NE(
        kept([](Budget& b) { b.program.facts.stages[1].facts.showsPrimitives = true; }).find("triangles"),
        std::string::npos);
    kept([](Budget&) {}, "Flat\n");
    EXPECT_NE(kept([](Budget& b) {
                  b.program.facts.stages.push_back({glsl::Stage::geometry, "", {}, "a.geom", {}, {}});
              }).find("geometry stage"),
              std::string::npos);
}

TEST(Choose, DrawsThatNeedAboutTheSameShareAMesh) {
    Budget budget(kEye + "Sphere\nTranslate .5 0 0\nSphere\nTranslate 0 0 -100\nSphere\n");
    budget.choose();
    EXPECT_EQ(budget.draw(0).shape, budget.draw(1).shape);
    EXPECT_NE(budget.draw(0).shape, budget.draw(2).shape);
    EXPECT_LT(budget.numbers(2)[1], budget.numbers(0)[1] / 2);
    EXPECT_EQ(budget.scene.shapes.size(), 2U);
}

TEST(Choose, GivesLeastToWhatIsNotInView) {
    Budget budget(kEye + "Translate 0 0 50\nSphere\n");
    budget.choose();
    EXPECT_EQ(budget.numbers(0), (std::vector<double>{1, 3, 2}));
    EXPECT_NE(budget.decision("Sphere").find("not in view"), std::string::npos);
}

TEST(Choose, CountsFixedByTheLanguageAreOpen) {
    Budget budget(kEye + kProgram + "Scale 2\nTeapot\nSoccerball\nXarrow 50\n");
    budget.request.maxError = .02;
    budget.choose();
    ASSERT_EQ(budget.numbers(0).size(), 1U);
    EXPECT_GT(budget.numbers(0)[0], 16);
    EXPECT_GT(budget.numbers(1).at(1), 8);
    EXPECT_EQ(budget.numbers(2)[0], 50);
    EXPECT_GT(budget.numbers(2).at(1), 24);
}

TEST(Choose, SaysWhatTheDriverAndTheLimitsAllow) {
    Budget budget(kEye + "Sphere\n");
    budget.request.maxError = 1e-9;
    const Choice& choice = budget.choose();
    ASSERT_EQ(choice.diagnostics.size(), 2U);
    for (const Diagnostic& each : choice.diagnostics) EXPECT_EQ(each.id, "draw-W07");
    EXPECT_NE(choice.diagnostics[0].text.find("4 samples"), std::string::npos);
    EXPECT_NE(choice.diagnostics[1].text.find("the largest possible"), std::string::npos);
    EXPECT_EQ(choice.diagnostics[1].place.line, 2);
    EXPECT_EQ(choice.samples, 4);
}

TEST(Choose, LeavesSamplesThatAreStated) {
    Budget budget(kEye + "Sphere\n");
    budget.request.areSamplesFree = false;
    EXPECT_EQ(budget.choose().samples, 1);
    EXPECT_EQ(budget.decision("samples"), "none");
}

TEST(Choose, JudgesAPassIntoATextureInItsTexels) {
    const std::string toTexture =
        "Texture2D 6 60 60\nRenderToTexture 6\n" + kEye + "Sphere\nRenderToTexture\n";
    Budget budget(toTexture + kProgram + "QuadXY\n");
    budget.addSampler("uTexUnit", scene::TextureTarget::texture2D, "sampler2D");
    budget.scene.programs.at(0).uniforms = {{"uTexUnit", glib::UniformForm::number, {6}, {}, {}}};
    budget.choose();
    Budget whole(kEye + "Sphere\n");
    whole.choose();
    // A tenth of the pixels, so the slices are fewer by the square root of ten.
    EXPECT_NEAR(budget.numbers(0)[1], whole.numbers(0)[1] / std::sqrt(10), 2);
}

}  // namespace
}  // namespace glibra::budget
