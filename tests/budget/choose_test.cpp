// The choice for whole scenes, without GL: programs are described by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "budget/budget.h"
#include "budget/least_counts.h"
#include "glib/script.h"
#include "scene/interpret.h"
#include "scene/view.h"

namespace glibra::budget {
namespace {

/// A scene, its plan with one description for all programs, and the choice.
class Budget {
  public:
    explicit Budget(const std::string& text) {
        program.usable = true;
        program.facts.placement = glsl::Placement::vertex;
        program.facts.stages = {{glsl::Stage::vertex, "void main() {}", {}, "a.vert", {}},
                                {glsl::Stage::fragment, "void main() {}", {}, "a.frag", {}}};
        program.inputs = {{"aVertex", 0, false}};
        const glib::Script script = glib::parse(text, "/tmp/scene.glib");
        EXPECT_TRUE(script.diagnostics.empty()) << script.diagnostics.front().text;
        scene = scene::interpret(script);
        request.maxError = .25;
        request.width = request.height = 600;
        request.mostSamples = 4;
        request.clipFromModel = [](const scene::Draw& draw, double aspect) {
            return scene::projectionMatrix(draw.projection, aspect) * draw.modelView;
        };
    }

    void addSampler(const char* name, scene::TextureTarget target, const char* word) {
        plan::ActiveUniform uniform;
        uniform.name = name;
        uniform.type = {plan::BaseType::sampler, 1, 1, target, word};
        uniform.location = 0;
        program.uniforms.push_back(uniform);
    }

    /// Chooses and puts the choice into the scene.
    const Choice& choose() {
        plan::ProgramInterface builtin;
        builtin.usable = builtin.isBuiltin = true;
        builtin.inputs = {{"aVertex", 0, false}};
        const plan::FramePlan plan = plan::planFrame(
            scene,
            [&](const plan::ProgramVariant& variant) -> const plan::ProgramInterface& {
                return variant.program == scene::kNone ? builtin : program;
            },
            [](int) { return false; }, {});
        choice = budget::choose(scene, plan, request);
        replaced = apply(choice, scene);
        return choice;
    }

    [[nodiscard]] const scene::Draw& draw(std::size_t index) const {
        return std::get<scene::Draw>(scene.passes.front().steps.at(index));
    }
    [[nodiscard]] const std::vector<double>& numbers(std::size_t index) const {
        return scene.shapes.at(static_cast<std::size_t>(draw(index).shape)).numbers;
    }
    [[nodiscard]] std::string decision(const std::string& what) const {
        for (const Decision& each : choice.decisions)
            if (each.what == what) return each.why;
        return "none";
    }

    scene::Scene scene;
    plan::ProgramInterface program;
    Request request;
    Choice choice;
    std::vector<int> replaced;
};

const std::string kProgram = "Vertex a.vert\nFragment a.frag\nProgram P uKd .5\n";
const std::string kEye = "LookAt 0 0 4 0 0 0 0 1 0\n";

TEST(Choose, GivesASphereTheLeastCountsForItsPixels) {
    Budget budget(kEye + "Sphere\n");
    budget.choose();
    // 300 cot(25 degrees) pixels a unit at distance 1, sideways views included; the sphere's nearest point is
    // at distance 3.
    const double straight = 300 / std::tan(25 * std::numbers::pi / 180) / 3;
    const auto& chosen = budget.numbers(0);
    const double off = surfaceModel(glib::CommandId::sphere)->deviation(chosen, Fidelity::shape);
    EXPECT_LE(off * straight, .25);
    EXPECT_GE(off * straight, .25 / 1.3);
    EXPECT_EQ(budget.choice.diagnostics.size(), 0U);
    EXPECT_EQ(budget.replaced, std::vector<int>{0});
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
    EXPECT_NE(choice.diagnostics[0].text.find("so is 1 more"), std::string::npos);
}

TEST(Choose, ChoosesTheRestOfWhatIsStatedInPart) {
    Budget budget(kEye + "Sphere 1 80\n");
    budget.choose();
    EXPECT_EQ(budget.numbers(0)[1], 80);
    const auto off = [&](double stacks) {
        return surfaceModel(glib::CommandId::sphere)
            ->deviation(std::vector{1., 80., stacks}, Fidelity::shape);
    };
    Budget open(kEye + "Sphere\n");
    open.choose();
    const double allowed = surfaceModel(glib::CommandId::sphere)->deviation(open.numbers(0), Fidelity::shape);
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
        each->program.inputs.push_back({"aNormal", 1, false});
    }
    plain.program.facts.stages[1].source = "void main() { float s = pow(reflect(vLight, vNormal).z, 9.); }";
    mirror.program.facts.stages[1].source =
        "uniform samplerCube u; void main() { vec4 c = texture(u, reflect(vSight, vNormal)); }";
    plain.choose();
    mirror.choose();
    EXPECT_EQ(plain.numbers(0), (std::vector<double>{1, 36, 18}));
    EXPECT_EQ(mirror.numbers(0), (std::vector<double>{1, 72, 36}));
}

/// A scene whose program computes light at the vertices, which is off by 8/255 with `slices` slices.
class LitBudget : public Budget {
  public:
    LitBudget(const std::string& sphere, double slices) : Budget(kEye + kProgram + sphere) {
        program.facts.stages[0].source = "void main() { vLight = pow(dot(n, l), 40.); }";
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
    EXPECT_NE(coarse.decision("Sphere").find("what its program makes of the vertices"), std::string::npos);
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
    budget.program.facts.stages[0].source =
        "layout(location = 0) in vec4 aVertex;\nvoid main() { vN = normalize(uNormalMatrix * aNormal);\n"
        "gl_Position = uModelViewProjectionMatrix * vec4(aVertex.xyz, 1.); }";
    budget.request.contourShift = [](const Choice&, const Choice&) {
        ADD_FAILURE() << "no picture is needed";
        return std::optional<ContourShifts>();
    };
    budget.choose();
}

TEST(Choose, IsFinerForAProgramThatReadsTextureCoordinates) {
    Budget plain(kEye + kProgram + "Sphere\n"), textured(kEye + kProgram + "Sphere\n");
    textured.program.inputs.push_back({"aTexCoord0", 1, false});
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
    EXPECT_NE(kept([](Budget& b) {
                  b.program.facts.stages[1].source = "flat in vec3 vN; void main() {}";
              }).find("triangles"),
              std::string::npos);
    kept([](Budget& b) { b.program.facts.stages[1].source = "n = cross(dFdx(p), dFdy(p));"; });
    kept([](Budget&) {}, "Flat\n");
    EXPECT_NE(kept([](Budget& b) {
                  b.program.facts.stages.push_back({glsl::Stage::geometry, "", {}, "a.geom", {}});
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
    EXPECT_NE(choice.diagnostics[1].text.find("the most there may be"), std::string::npos);
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
    budget.scene.programs[0].uniforms = {{"uTexUnit", glib::UniformForm::number, {6}, {}, {}}};
    budget.choose();
    Budget whole(kEye + "Sphere\n");
    whole.choose();
    // A tenth of the pixels, and so a root of ten fewer slices.
    EXPECT_NEAR(budget.numbers(0)[1], whole.numbers(0)[1] / std::sqrt(10), 2);
}

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
        const auto& noise = std::get<scene::NoiseSource>(scene.textures[1].source);
        return {noise.size, noise.texels};
    }
};
constexpr auto kBytes = scene::NoiseTexels::bytes, kShorts = scene::NoiseTexels::shorts;

TEST(Choose, ChoosesTheNoiseThatTheSceneLeavesOpen) {
    // About 250 pixels a unit; 64 texels are off by .0082 of a period, bytes by .0017.
    EXPECT_EQ(NoiseBudget("", 4).chosen(), (NoiseFormat{64, kBytes}));
    EXPECT_EQ(NoiseBudget("", .7).chosen(), (NoiseFormat{128, kBytes}));
    EXPECT_EQ(NoiseBudget("", .25).chosen(), (NoiseFormat{192, kShorts}));
    EXPECT_EQ(NoiseBudget("", 10).chosen(), (NoiseFormat{32, kBytes}));
    EXPECT_EQ(NoiseBudget("Noise3D 100\n", .25).chosen(), (NoiseFormat{100, kBytes}));
    NoiseBudget free("Noise3D 100\n", .25);
    free.request.overrideCounts = true;
    EXPECT_EQ(free.chosen(), (NoiseFormat{192, kShorts}));
    EXPECT_NE(free.decision("Noise3D").find("192 texels a side of 16 bits in place of 100"),
              std::string::npos);
}

/// Two pictures of a slope of a 100th a pixel that moves by that many pixels.
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
            EXPECT_EQ(to.noise.front().texture, 1);
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
    // The same, hardly to be seen.
    EXPECT_EQ(chosenFor(slopes(10, .05F), 4), (NoiseFormat{64, kBytes}));
    EXPECT_EQ(chosenFor(std::nullopt, .25), (NoiseFormat{192, kShorts}));
}

TEST(Choose, SaysWhatNoiseCannotKeep) {
    NoiseBudget stated("Noise3D 40\n", .25);
    stated.choose();
    ASSERT_EQ(stated.choice.diagnostics.size(), 1U);
    EXPECT_EQ(stated.choice.diagnostics[0].id, "draw-N03");
    EXPECT_NE(stated.choice.diagnostics[0].text.find("Noise3D with 40 texels"), std::string::npos);
    // The sizes of a scene are judged by pictures too.
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
