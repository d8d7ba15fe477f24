// Variables, expressions, groups and repetitions (language, 12).

#include <gtest/gtest.h>

#include <array>

#include "glib/script.h"
#include "support.h"

namespace glibra::scene {
namespace {

using tests::drawsOf;
using tests::idsOf;
using tests::placeOf;
using tests::run;
using tests::sceneAt;
using tests::scriptOf;
using tests::TemporaryFolder;
using tests::textsOf;
using tests::uniformOf;
using tests::uniformValues;

TEST(Modern, ExpressionsFillTheArgumentsOfClassicCommands) {
    const Scene scene = run("Translate (1 + 2) 0 (1 / 4)\nBox (vec3(1, 2, 3))\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    const std::vector<Draw> draws = drawsOf(scene);
    ASSERT_EQ(draws.size(), 1U);
    EXPECT_EQ(placeOf(draws[0]), glm::dvec3(3, 0, .25));
    const std::vector<double>& box = scene.shapes[draws[0].shape].numbers;
    EXPECT_EQ(std::vector<double>(box.begin(), box.begin() + 3), (std::vector<double>{1, 2, 3}));
}

TEST(Modern, AnEvaluatedNumberObeysTheRuleOfItsArgument) {
    EXPECT_EQ(idsOf(run("Sphere (0-2)\n").diagnostics), "glib-W28");
    EXPECT_EQ(idsOf(run("Perspective (100 + 100) .1 10\nSphere\n").diagnostics), "glib-E05");
}

TEST(Modern, AScriptWithTimeGivesADifferentSceneForEachTime) {
    Interpretation script = scriptOf("Translate (2 * time) 0 0\nBox\n");
    EXPECT_EQ(placeOf(drawsOf(sceneAt(script, 0))[0]).x, 0);
    EXPECT_EQ(placeOf(drawsOf(sceneAt(script, 1.5))[0]).x, 3);
    EXPECT_TRUE(any(script.depends() & expression::Depends::time));
    EXPECT_EQ(placeOf(drawsOf(sceneAt(script, 0))[0]).x, 0) << "and the same for the same time";

    Interpretation still = scriptOf("Let size <1 2 3>\nBox (size)\n");
    sceneAt(still, 0);
    EXPECT_FALSE(any(still.depends() & expression::Depends::time));
}

TEST(Modern, VariablesOfEveryForm) {
    const Scene scene =
        run("Let speed <0 .5 2>\nLet mode <red green blue>\nLet on <true>\nLet tint {.1 .2 .3}\nLet n 3\n"
            "Let v [4 5]\nLet twice (2 * speed)\n"
            "Translate (twice) (mode) (on ? 1 : 0)\nBox\nTranslate (tint.g) (v.y) (n)\nBox\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    const std::vector<Draw> draws = drawsOf(scene);
    ASSERT_EQ(draws.size(), 2U);
    EXPECT_EQ(placeOf(draws[0]), glm::dvec3(1, 0, 1));
    EXPECT_EQ(placeOf(draws[1]), glm::dvec3(1 + .2, 5, 4));
    ASSERT_EQ(scene.variables.size(), 5U) << "expressions and lists have no control";
    EXPECT_EQ(scene.variables[0].written, (std::vector<double>{0, .5, 2}));
    EXPECT_EQ(scene.variables[1].words, (std::vector<std::string>{"red", "green", "blue"}));
    EXPECT_EQ(scene.variables[2].form, glib::UniformForm::truth);
    EXPECT_EQ(scene.variables[3].form, glib::UniformForm::color);
}

TEST(Modern, ARangeOfAVectorHasACurrentValuePerComponent) {
    constexpr std::array<const char*, 3> kCurrent{"0 3", "0 3 2", "0 3 2 1"};
    for (std::size_t i = 0; i < kCurrent.size(); ++i) {
        Interpretation script = scriptOf(std::string("Let v <-5 ") + kCurrent.at(i) +
                                         " 5>\nTranslate (v.y) (v.x) (dot(v, v))\nBox\n");
        const Scene& scene = script.at({});
        EXPECT_EQ(textsOf(scene.diagnostics), "");
        ASSERT_EQ(scene.variables.size(), 1U);
        const Variable& variable = scene.variables.front();
        EXPECT_EQ(variable.current.size(), i + 2);
        EXPECT_EQ(variable.least(), -5);
        EXPECT_EQ(variable.largest(), 5);
        EXPECT_EQ(placeOf(drawsOf(scene).front()), glm::dvec3(3, 0, i == 0 ? 9 : i == 1 ? 13 : 14));
        FrameInputs inputs;
        inputs.variables["v"] = std::vector<double>(i + 2, 1);
        EXPECT_EQ(placeOf(drawsOf(script.at(inputs)).front()), glm::dvec3(1, 1, static_cast<double>(i) + 2));
    }
    EXPECT_EQ(textsOf(run("Let v <0 (vec2(3, 9)) 5>\nTranslate (v) 0\nBox\n").diagnostics),
              "1:7 glib-W21 v: current value 9 is outside 0 ... 5; it is kept");
    EXPECT_EQ(idsOf(run("Let v <5 1 1 0>\nTranslate (v) 0\nBox\n").diagnostics), "glib-E26");
    EXPECT_EQ(idsOf(run("Bound v <1 2 3 4>\nBox (v)\n").diagnostics), "glib-E26");
    EXPECT_EQ(textsOf(run("Let v <0 1 1 5>\nKey k v (v + 9)\nTranslate (v) 0\nBox\n").diagnostics), "")
        << "steps stop at the ends";
    EXPECT_EQ(idsOf(run("Let v <0 1 1 5>\nKey k v [1 9]\nTranslate (v) 0\nBox\n").diagnostics), "glib-E05");
    EXPECT_EQ(idsOf(run("Let v <0 1 1 5>\nKey k v 3\nTranslate (v) 0\nBox\n").diagnostics), "glib-E26");
}

TEST(Modern, CurrentValuesAndNumbersOfChoicesOutsideTheirRangesAreReported) {
    EXPECT_EQ(textsOf(run("Let a <1 90 25>\nBox (a)\n").diagnostics),
              "1:7 glib-W21 a: current value 90 is outside 1 ... 25; it is kept");
    Interpretation script = scriptOf("Let u <red green blue>\nTranslate (u) 0 0\nBox\n");
    FrameInputs inputs;
    inputs.variables["u"] = {2};
    EXPECT_EQ(textsOf(script.at(inputs).diagnostics), "");
    inputs.variables["u"] = {7};
    EXPECT_EQ(textsOf(script.at(inputs).diagnostics),
              "1:7 glib-E05 'u' is set to 7, but it is one of red, green, blue, which are 0 to 2");
}

TEST(Modern, AListOfARuleIsAnArray) {
    const Scene scene =
        run("Let w [6 of (vec3(i, 1, 2))]\nLet q [4 of (2)]\nLet n [3 of 5]\nLet k 2\n"
            "Let r [(k) of (i == 0 ? 7 : r[0] + i)]\n"
            "Expect (w.count == 6 && q.count == 4 && n.count == 3 && r.count == 2)\n"
            "Translate (w[5].x) (q[3] + n[2]) (r[1])\nBox\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    ASSERT_EQ(drawsOf(scene).size(), 1U);
    EXPECT_EQ(placeOf(drawsOf(scene)[0]), glm::dvec3(5, 7, 8));
    EXPECT_EQ(textsOf(run("Let q[4] [4 of (2)]\n").diagnostics),
              "1:10 glib-E32 'q' has two counts; write 'Let q[4] (2)'");
}

TEST(Modern, InputsReplaceTheValuesOfVariables) {
    Interpretation script = scriptOf("Let size <1 2 3>\nTranslate (size) 0 0\nBox\n");
    FrameInputs inputs;
    inputs.variables["size"] = {3};
    inputs.variables["other"] = {1};
    const Scene scene = script.at(inputs);
    EXPECT_EQ(placeOf(drawsOf(scene)[0]).x, 3);
    EXPECT_EQ(scene.usedVariables.at("size"), 1U);
    EXPECT_FALSE(scene.usedVariables.contains("other"));
    EXPECT_EQ(scene.variables[0].written[1], 2) << "what the file says";
    EXPECT_EQ(scene.variables[0].current, std::vector<double>{3});
    inputs.variables["size"] = {1, 2};
    EXPECT_EQ(placeOf(drawsOf(script.at(inputs))[0]).x, 2) << "a value of another size is ignored";
}

TEST(Modern, AnArrayMayReadItsEarlierElements) {
    const Scene scene =
        run("Let sum[5] (i == 0 ? 1 : 2 * sum[i - 1])\n"
            "Let pose[3] (i == 0 ? translate(1, 0, 0) : pose[i - 1] * translate(1, 0, 0))\n"
            "Translate (sum[4]) (pose[2][3].x) 0\nBox\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    EXPECT_EQ(placeOf(drawsOf(scene)[0]), glm::dvec3(16, 3, 0));
}

TEST(Modern, SetChangesUniformsUntilItsScopeEnds) {
    const Scene scene =
        run("Vertex a.vert\nFragment a.frag\nProgram P uA 1\nSet uA 2\nBox\nGroup\nSet uA 3 uB {1 0 "
            "0}\nBox\nEndGroup\n"
            "Box\n");
    const std::vector<Draw> draws = drawsOf(scene);
    ASSERT_EQ(draws.size(), 3U);
    EXPECT_EQ(uniformValues(scene, draws[0], "uA"), std::vector<double>{2});
    EXPECT_EQ(uniformValues(scene, draws[1], "uA"), std::vector<double>{3});
    EXPECT_EQ(uniformValues(scene, draws[1], "uB"), (std::vector<double>{1, 0, 0}));
    EXPECT_EQ(uniformValues(scene, draws[2], "uA"), std::vector<double>{2});
    EXPECT_EQ(draws[0].uniforms, draws[2].uniforms) << "equal values are shared";
}

TEST(Modern, TagsOfAProgramAreEvaluatedAtItsDraws) {
    const Scene scene =
        run("Let k 2\nVertex a.vert\nFragment a.frag\nProgram P uPlace (model[3].xyz) uK k uList [3 of (i * "
            "i)] uPlain 4\n"
            "Translate 1 0 0\nBox\nTranslate 1 0 0\nBox\n");
    EXPECT_EQ(textsOf(scene.diagnostics).find('E'), std::string::npos) << textsOf(scene.diagnostics);
    const std::vector<Draw> draws = drawsOf(scene);
    ASSERT_EQ(draws.size(), 2U);
    EXPECT_EQ(uniformValues(scene, draws[0], "uPlace"), (std::vector<double>{1, 0, 0}));
    EXPECT_EQ(uniformValues(scene, draws[1], "uPlace"), (std::vector<double>{2, 0, 0}));
    EXPECT_EQ(uniformValues(scene, draws[1], "uK"), std::vector<double>{2});
    EXPECT_EQ(uniformValues(scene, draws[1], "uList"), (std::vector<double>{0, 1, 4}));
    EXPECT_EQ(uniformOf(scene, draws[1], "uPlain"), nullptr) << "plain numbers stay with the program";
    EXPECT_EQ(scene.programs.at(0).uniforms.at(0).tag, "uPlain");
}

TEST(Modern, AVariableOfAnyMagnitudeIsATagsValue) {
    for (const double value : {1e20, -1e20, .5}) {
        const Scene scene =
            run("Let k " + std::to_string(value) + "\nVertex a.vert\nFragment a.frag\nProgram P uK k\nBox\n");
        const std::vector<Draw> draws = drawsOf(scene);
        ASSERT_EQ(draws.size(), 1U);
        EXPECT_EQ(uniformValues(scene, draws[0], "uK"), std::vector<double>{value});
        EXPECT_EQ(uniformOf(scene, draws[0], "uK")->word, "") << value;
    }
}

TEST(Modern, MaterialsSetTheirFourMembers) {
    const Scene scene = run("Vertex a.vert\nFragment a.frag\nProgram P\nMaterial gold\nBox\n");
    const Draw draw = drawsOf(scene).at(0);
    EXPECT_EQ(uniformValues(scene, draw, "material.diffuse"), (std::vector<double>{.7516, .6065, .2265, 1}));
    EXPECT_EQ(uniformValues(scene, draw, "material.shininess"), std::vector<double>{51.2});
    const Scene chosen = run(
        "Vertex a.vert\nFragment a.frag\nProgram P\nRepeat [silver gold] as metal\nMaterial (metal)\nBox\n"
        "EndRepeat\n");
    EXPECT_EQ(textsOf(chosen.diagnostics), "");
    EXPECT_EQ(uniformValues(chosen, drawsOf(chosen).at(1), "material.diffuse"),
              (std::vector<double>{.7516, .6065, .2265, 1}));
    const Scene wrong = run("Material glod\nBox\n");
    EXPECT_EQ(textsOf(wrong.diagnostics), "1:10 glib-E16 no material 'glod'; did you mean 'gold'?");
}

TEST(Modern, GroupsAreDrawnWithTheTransformsOfTheCaller) {
    const Scene scene =
        run("Group arm length 1\nTranslate (length) 0 0\nBox\nEndGroup\n"
            "Translate 0 5 0\nDraw arm\nDraw arm length 3\nBox\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    const std::vector<Draw> draws = drawsOf(scene);
    ASSERT_EQ(draws.size(), 3U);
    EXPECT_EQ(placeOf(draws[0]), glm::dvec3(1, 5, 0));
    EXPECT_EQ(placeOf(draws[1]), glm::dvec3(3, 5, 0));
    EXPECT_EQ(placeOf(draws[2]), glm::dvec3(0, 5, 0)) << "transforms end with the group";
}

TEST(Modern, GroupsMayDrawOtherGroupsButNotThemselves) {
    const Scene scene =
        run("Group moon\nTranslate 2 0 0\nBox .5\nEndGroup\nGroup planet\nTranslate 4 0 0\nDraw moon\nBox "
            "2\nEndGroup\n"
            "Draw planet\n");
    const std::vector<Draw> draws = drawsOf(scene);
    ASSERT_EQ(draws.size(), 2U);
    EXPECT_EQ(placeOf(draws[0]).x, 6);
    EXPECT_EQ(placeOf(draws[1]).x, 4);
    EXPECT_EQ(idsOf(run("Group a\nDraw a\nEndGroup\nDraw a\n").diagnostics), "glib-E28");
    EXPECT_EQ(textsOf(run("Group tree\nBox\nEndGroup\nDraw tre\n").diagnostics),
              "4:6 glib-E27 no group 'tre' is declared before this line; did you mean 'tree'?");
    EXPECT_EQ(textsOf(run("Group a size 1\nBox\nEndGroup\nDraw a sise 2\n").diagnostics),
              "4:8 glib-E27 group 'a' has no parameter 'sise'; did you mean 'size'?");
}

TEST(Modern, RepeatCountsAndWhenChooses) {
    const Scene scene =
        run("Repeat 3 as k\nWhen (k == 1)\nBox\nElse\nTranslate (k) 0 0\nSphere\nEndWhen\nEndRepeat\n"
            "Repeat [add sub] as op\nTranslate (op.index) (op == sub ? 7 : 0) 0\nCone\nEndRepeat\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    const std::vector<Draw> draws = drawsOf(scene);
    ASSERT_EQ(draws.size(), 5U);
    EXPECT_EQ(draws[0].word, "Sphere");
    EXPECT_EQ(draws[1].word, "Box");
    EXPECT_EQ(draws[2].word, "Sphere");
    EXPECT_EQ(placeOf(draws[2]).x, 2);
    EXPECT_EQ(placeOf(draws[3]), glm::dvec3(0, 0, 0));
    EXPECT_EQ(placeOf(draws[4]), glm::dvec3(1, 7, 0));
}

TEST(Modern, AFrameHasALimitOfStatements) {
    EXPECT_EQ(idsOf(run("Repeat 1000000000\nBox\nEndRepeat\n").diagnostics), "glib-E15");
    EXPECT_EQ(idsOf(run("Repeat 2000\nRepeat 1000\nColor 1 0 0\nEndRepeat\nEndRepeat\nBox\n").diagnostics),
              "glib-E15");
}

TEST(Modern, IncludedStatementsKeepTheirPlaces) {
    const TemporaryFolder folder;
    folder.write("part.glib", "Translate 1 0 0\nMaterial glod\nBox\n");
    const std::filesystem::path scene = folder.write("scene.glib", "");
    const Scene included = run("Include part.glib\nBox\n", scene);
    EXPECT_EQ(drawsOf(included).size(), 2U);
    ASSERT_EQ(included.diagnostics.size(), 1U);
    EXPECT_EQ(std::filesystem::path(included.diagnostics[0].place.file).filename(), "part.glib");
    EXPECT_EQ(included.diagnostics[0].place.line, 2);
    folder.write("self.glib", "Include self.glib\n");
    EXPECT_EQ(idsOf(run("Include self.glib\n", scene).diagnostics), "glib-E28");
    EXPECT_EQ(idsOf(run("Include missing.glib\n", scene).diagnostics), "file-E01");
}

TEST(Modern, FilesKeepTheirIndicesFromFrameToFrame) {
    const TemporaryFolder folder;
    folder.write("a.obj", "v 0 0 0\n");
    folder.write("b.obj", "v 0 0 0\n");
    Interpretation script =
        scriptOf("When (time < 1)\nObj a.obj\nEndWhen\nObj b.obj\n", folder.write("scene.glib", ""));
    const Scene first = sceneAt(script, 2), second = sceneAt(script, 0), third = sceneAt(script, 2);
    const auto fileOf = [](const Scene& scene, std::size_t draw) {
        const Draw made = drawsOf(scene).at(draw);
        return std::pair(scene.shapes[made.shape].file.position(),
                         scene.files[scene.shapes[made.shape].file].name);
    };
    EXPECT_EQ(fileOf(first, 0), std::pair(std::size_t{0}, std::string("b.obj")));
    EXPECT_EQ(fileOf(second, 0).second, "a.obj");
    EXPECT_EQ(fileOf(second, 1), fileOf(first, 0));
    EXPECT_EQ(fileOf(third, 0), fileOf(first, 0));
}

TEST(Modern, AFileWithDeclarationsIsNotIncludedInsideABlock) {
    const TemporaryFolder folder;
    folder.write("part.glib", "Vertex a.vert\nFragment a.frag\nProgram P\n");
    const std::filesystem::path scene = folder.write("scene.glib", "");
    EXPECT_EQ(idsOf(run("When (1 == 1)\nInclude part.glib\nEndWhen\n", scene).diagnostics), "glib-E23");
    EXPECT_EQ(run("Let a 1\nInclude part.glib\n", scene).programs.size(), 1U);
}

TEST(Modern, AShaderMayStandInTheScript) {
    const Scene scene =
        run("Fragment inline\nvoid main() {\n}\nEndFragment\nVertex a.vert\nProgram P\nBox\n");
    ASSERT_EQ(scene.programs.size(), 1U);
    const FileReference& file = scene.files[scene.programs.at(0).stages.at(1).file];
    ASSERT_TRUE(file.text.has_value());
    EXPECT_EQ(*file.text, "\nvoid main() {\n}\n") << "on its lines of the script";
}

TEST(Modern, UseMakesAnEarlierProgramCurrent) {
    const Scene scene =
        run("Vertex a.vert\nFragment a.frag\nProgram One\nProgram Two\nBox\nUse One\nBox\nGroup\nUse "
            "Two\nBox\nEndGroup\nBox\n");
    const std::vector<Draw> draws = drawsOf(scene);
    ASSERT_EQ(draws.size(), 4U);
    EXPECT_EQ(draws[0].program.position(), 1U);
    EXPECT_EQ(draws[1].program.position(), 0U);
    EXPECT_EQ(draws[2].program.position(), 1U);
    EXPECT_EQ(draws[3].program.position(), 0U);
    EXPECT_EQ(idsOf(run("Let a 1\nUse None\nBox\n").diagnostics), "glib-E27");
}

TEST(ModernPasses, ClearEachTargetToAColourOfItsOwn) {
    const std::string textures = "Texture2D a 4 4 rgba8\nTexture2D b 4 4 r8\n";
    const Scene scene =
        run(textures + "Pass a b clear {1 0 0 1} {0 0 1 0}\nEndPass\nPass a b clear {0 1 0}\nEndPass\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    ASSERT_GE(scene.frame.passes.size(), 2U);
    using ClearColors = std::vector<std::optional<glm::dvec4>>;
    EXPECT_EQ(scene.frame.passes[0].clearColors,
              (ClearColors{glm::dvec4(1, 0, 0, 1), glm::dvec4(0, 0, 1, 0)}));
    EXPECT_EQ(scene.frame.passes[1].clearColors,
              (ClearColors{glm::dvec4(0, 1, 0, 1), glm::dvec4(0, 1, 0, 1)}));
    const Scene kept =
        run(textures + "Texture2D z 4 4 depth24\nPass a b z clear {1 0 0 1} keep depth\nEndPass\n");
    EXPECT_EQ(textsOf(kept.diagnostics), "");
    ASSERT_GE(kept.frame.passes.size(), 1U);
    EXPECT_EQ(kept.frame.passes[0].clearColors,
              (ClearColors{glm::dvec4(1, 0, 0, 1), glm::dvec4(1, 0, 0, 1)}));
    EXPECT_FALSE(kept.frame.passes[0].clearDepth);
    EXPECT_EQ(idsOf(run(textures + "Pass a b clear {1 0 0} {1 0 0} {1 0 0}\nEndPass\n").diagnostics),
              "glib-E26");
}

TEST(Buffers, HaveTheValuesThatTheNamesHadAtTheirStatement) {
    const Scene scene =
        run("Let k (2)\nLet list [3 5 7]\nBuffer b vec2 3 (vec2(k*i, list[int(i)]))\nLet k (9)\n");
    ASSERT_EQ(scene.buffers.size(), 1U) << textsOf(scene.diagnostics);
    EXPECT_EQ(scene.buffers.at(0).values.numbers(), (std::vector<double>{0, 3, 2, 5, 4, 7}));
}

TEST(UniformSets, OfEqualValuesAreSharedWhereverTheyStand) {
    const Scene scene =
        run("Texture2D a 8 8 rgba8\nTexture2D b 8 8 rgba8\nRepeat 6 as k\nSet uK (mod(k, 2)) uM "
            "a\nBox\nEndRepeat\n"
            "Set uK 1 uM a\nBox\nSet uM b\nBox\nSet uK {1 1 1}\nBox\n");
    EXPECT_EQ(drawsOf(scene).size(), 9U) << textsOf(scene.diagnostics);
    EXPECT_EQ(scene.uniformSets.size(), 4U);
}

TEST(Choices, NameTheTopologyOfVertices) {
    const std::string text = "Vertices (k) 12\n";
    const Scene chosen = run("Let k <triangles lines>\n" + text);
    ASSERT_EQ(drawsOf(chosen).size(), 1U) << textsOf(chosen.diagnostics);
    EXPECT_EQ(chosen.shapes[drawsOf(chosen)[0].shape].bare, geometry::Topology::triangles);
    const Scene scene = run("Repeat [triangles line_strip] as k\n" + text + "EndRepeat\n");
    ASSERT_EQ(tests::drawsOf(scene).size(), 2U) << textsOf(scene.diagnostics);
    EXPECT_EQ(scene.shapes[tests::drawsOf(scene)[0].shape].bare, geometry::Topology::triangles);
    EXPECT_EQ(scene.shapes[tests::drawsOf(scene)[1].shape].strip, geometry::ListTopology::lineStrip);
}

TEST(Choices, NameTexturesAndBuffersOnTags) {
    const std::string begin =
        "Texture2D red 8 8 rgba8 levels 2\nTexture2D blue 8 8 rgba8 levels 2\nLet pic <red blue>\n"
        "Group g what red\nSet uWhat what\nBox\nEndGroup\nKey p pic blue\n";
    const auto boundIn = [&](const std::string& text, const char* tag) -> std::string {
        const InterpretOptions options;
        Interpretation script(glib::parse(begin + text, "scene.glib"), options);
        FrameInputs inputs;
        inputs.words["pic"] = "blue";
        const Scene scene = script.at(inputs);
        const Draw draw = drawsOf(scene).at(0);
        if (!draw.uniforms) return "nothing " + textsOf(scene.diagnostics);
        for (const ObjectBinding& each : scene.uniformSets[draw.uniforms].objects)
            if (const auto* view = std::get_if<TextureView>(&each.object); view && each.tag == tag)
                return scene.textures[view->texture].name +
                       (view->level ? std::to_string(*view->level) : std::string()) +
                       (each.isChosen ? " chosen" : "");
        return "none " + textsOf(scene.diagnostics);
    };
    EXPECT_EQ(boundIn("Set photo pic\nBox\n", "photo"), "blue chosen");
    EXPECT_EQ(boundIn("Set photo pic.level(1)\nBox\n", "photo"), "blue1");
    EXPECT_EQ(boundIn("Vertex a.vert\nFragment a.frag\nProgram P photo pic\nBox\n", "photo"), "blue chosen");
    EXPECT_EQ(boundIn("Repeat [blue red] as op\nSet photo op\nBox\nEndRepeat\n", "photo"), "blue chosen");
    EXPECT_EQ(boundIn("Draw g what pic\n", "uWhat"), "blue");
}

TEST(Arrays, MayGetAnotherLength) {
    const TemporaryFolder folder;
    folder.write("chain.glib",
                 "Let links 2\nLet reach[links + 1] (i * 10)\nBox (reach[links]) (reach.count) 1\n");
    const glib::Script text =
        glib::parse("Include chain.glib links 2\nInclude chain.glib links 4\nInclude chain.glib links 3\n",
                    folder.write("scene.glib", "").string());
    Interpretation script(text, {});
    for (int frame = 0; frame < 3; ++frame) {
        const Scene scene = script.at({});
        EXPECT_EQ(textsOf(scene.diagnostics), "");
        std::vector<double> sizes;
        for (const Draw& each : drawsOf(scene)) {
            sizes.push_back(scene.shapes[each.shape].numbers.at(0));
            sizes.push_back(scene.shapes[each.shape].numbers.at(1));
        }
        EXPECT_EQ(sizes, (std::vector<double>{20, 3, 40, 5, 30, 4}));
    }
}

}  // namespace
}  // namespace glibra::scene
