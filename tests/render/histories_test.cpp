// Objects with history begin a node with a copy of what they held, unless the node writes all of it.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "../glsl/whole_write_bodies.h"
#include "scene_text.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

constexpr const char* kCopies = "histories copied";
const std::vector<double> kTimes{0, .55};  // none and five of ten steps a second

/// A picture of 37 x 29 numbers, seeded by Once and changed by Step.
struct Field {
    std::string next;                           ///< the stage of a step
    std::string dispatch = "Next over field";   ///< what a step dispatches
    std::string texture = "field 37 29 r32ui";  ///< before `history`
    std::string more{};                         ///< statements before the blocks
    std::string once{};                         ///< statements of Once

    [[nodiscard]] std::string scene() const {
        return "WindowSize 37 29\nTexture2D " + texture + " history\n" + more +
               R"(Compute inline
#version 430 core
layout(local_size_x = 8, local_size_y = 8) in;
layout(r32ui) writeonly uniform uimage2D uOut;
void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, imageSize(uOut)))) return;
    imageStore(uOut, p, uvec4(uint(p.x * 73 + p.y * 1999)));
}
EndCompute
Program Start uOut field
Compute inline
)" + next + R"(
EndCompute
Program Next uIn field.prev uOut field
Fragment inline
#version 430 core
uniform usampler2D uField;
out vec4 fColor;
void main() {
    uint value = texelFetch(uField, ivec2(gl_FragCoord.xy), 0).r * 2654435761u;
    fColor = vec4(uvec3(value, value >> 8, value >> 16) & 255u, 255u) / 255.;
}
EndFragment
Program Show uField field
Once
    Dispatch Start over field
)" + once + R"(EndOnce
Step 10
    Dispatch )" +
               dispatch + R"(
EndStep
Fill window with Show
)";
    }
};

/// How often a history is copied. Fails the test unless the pictures are those of a run that copies always.
std::uint64_t copiesOf(const std::string& scene) {
    const SceneFolder folder(scene);
    RenderOptions options;
    const Drawing skipping = draw(folder, options, nullptr, kTimes);
    options.skip = false;
    const Drawing whole = draw(folder, options, nullptr, kTimes);
    EXPECT_EQ(text(skipping.diagnostics), "") << scene;
    EXPECT_TRUE(skipping.pixels == whole.pixels) << scene;
    EXPECT_GT(whole.count(kCopies), 0U) << scene;
    return skipping.count(kCopies);
}

class Histories : public testing::Test {
  protected:
    void SetUp() override {
        if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    }
};

TEST_F(Histories, AreCopiedUnlessTheTextShowsThatAllIsWritten) {
    for (const WholeWriteBody& each : kWholeWriteBodies) {
        if (std::string(each.statements).empty()) continue;
        EXPECT_EQ(copiesOf(Field{stageOf(each)}.scene()), each.isWhole ? 0U : 5U) << each.before << "\n"
                                                                                  << each.statements;
    }
}

TEST_F(Histories, AreCopiedUnlessTheInvocationsReachAll) {
    const std::string next = stageOf(kWholeWriteBodies[6]);  // with a guard
    // Groups have 8 x 4 invocations; the texture has 37 x 29 texels.
    for (const auto& [dispatch, isWhole] : {std::pair{"Next over field", true},
                                            {"Next over field.prev", true},
                                            {"Next over 37 29", true},
                                            {"Next over 40 32 1", true},
                                            {"Next over 33 29", true},
                                            {"Next over 32 29", false},
                                            {"Next over 37 28", false},
                                            {"Next over 37 24", false},
                                            {"Next over 37", false},
                                            {"Next 5 8", true},
                                            {"Next 5 8 2", true},
                                            {"Next 4 8", false},
                                            {"Next 5 7", false},
                                            {"Next 40", false},
                                            {"Next over field tiles 3", true},
                                            {"Next over 37 24 tiles 3", false}})
        EXPECT_EQ(copiesOf(Field{next, dispatch}.scene()), isWhole ? 0U : 5U) << dispatch;
}

TEST_F(Histories, AreCopiedIfASizeThatLimitsTheWritesIsSmaller) {
    const std::string next =
        stageOf({"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n"
                 "if (any(greaterThanEqual(p, imageSize(uIn)))) return;\n"
                 "imageStore(uOut, p, uvec4(imageLoad(uIn, p).r + 1u));",
                 true});
    for (const auto& [texture, isWhole] :
         {std::pair{"other 37 29 r32ui", true}, {"other 36 29 r32ui", false}, {"other 37 28 r32ui", false}}) {
        Field field{next};
        field.more = fmt::format("Texture2D {}\n", texture);
        field.once = "    Clear other\n";
        std::string scene = field.scene();
        const std::string bound = "uIn field.prev";
        scene.replace(scene.find(bound), bound.size(), "uIn other");
        EXPECT_EQ(copiesOf(scene), isWhole ? 0U : 5U) << texture;
    }
}

TEST_F(Histories, AreCopiedIfTheStepUsesOnlyAPartOrReadsWhatItWrites) {
    const std::string plain = stageOf(kWholeWriteBodies[0]);
    Field levels{plain};
    levels.texture = "field 37 29 r32ui nearest levels 2";
    EXPECT_EQ(copiesOf(levels.scene()), 6U) << "the seed leaves the second level, too";

    std::string aliased = Field{plain}.scene();
    const std::string bound = "uIn field.prev";
    aliased.replace(aliased.find(bound), bound.size(), "uIn field");
    EXPECT_EQ(copiesOf(aliased), 5U);
}

TEST_F(Histories, AreNotCopiedIfTheSceneSaysSo) {
    const std::string part =
        stageOf({"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n"
                 "for (int i = 0; i < 1; ++i) imageStore(uOut, p, after(p));",
                 false});
    const SceneFolder keeping(Field{part}.scene()),
        discarding(Field{part, "Next over field discard"}.scene());
    const Drawing kept = draw(keeping, {}, nullptr, kTimes);
    const Drawing discarded = draw(discarding, {}, nullptr, kTimes);
    EXPECT_EQ(text(discarded.diagnostics), "");
    EXPECT_EQ(kept.count(kCopies), 5U);
    EXPECT_EQ(kept.count("bytes copied"), 5U * 37 * 29 * 4);
    EXPECT_EQ(discarded.count(kCopies), 0U);
    EXPECT_TRUE(kept.pixels == discarded.pixels);
}

TEST_F(Histories, OfBuffers) {
    const auto scene = [](const std::string& statements, const std::string& dispatch) {
        return R"(WindowSize 20 20
Buffer Cells vec2 100 (vec2(i, 2*i)) history
Compute inline
#version 430 core
layout(local_size_x = 32) in;
layout(std430) readonly buffer Last { vec2 last[]; };
layout(std430) buffer Cells { vec2 cells[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
)" + statements +
               R"(
}
EndCompute
Program Next Last Cells.prev
Fragment inline
#version 430 core
layout(std430) readonly buffer Cells { vec2 cells[]; };
out vec4 fColor;
void main() { fColor = vec4(fract(cells[int(gl_FragCoord.x) % 10 + 10 * (int(gl_FragCoord.y) % 10)] / 50.), 0., 1.); }
EndFragment
Program Show
Step 10
    Dispatch )" +
               dispatch + "\nEndStep\nFill window with Show\n";
    };
    const std::string all = "    if (i >= cells.length()) return;\n    cells[i] = last[(i + 7u) % 100u].yx;";
    EXPECT_EQ(copiesOf(scene(all, "Next over Cells")), 0U);
    EXPECT_EQ(copiesOf(scene(all, "Next over Cells.prev")), 0U);
    EXPECT_EQ(copiesOf(scene(all, "Next over 97")), 0U);
    EXPECT_EQ(copiesOf(scene(all, "Next over 96")), 5U);
    EXPECT_EQ(copiesOf(scene(all, "Next 3")), 5U);
    EXPECT_EQ(copiesOf(scene("    if (i != 3u) cells[i] = last[i] + 1.;", "Next over Cells")), 5U);
    EXPECT_EQ(copiesOf(scene("    cells[i].x = last[i].y + 1.;", "Next over Cells")), 5U);
    EXPECT_EQ(copiesOf(scene("    cells[i] += last[i];", "Next over Cells")), 5U);
}

/// The first Fill of a run clears its target; later ones keep it, and cover it.
TEST_F(Histories, OfFilledTextures) {
    const auto scene = [](const std::string& statements, const std::string& fill) {
        return "WindowSize 31 17\nTexture2D heat 31 17 rgba32f history\nFragment inline\n#version 430 core\n"
               "uniform sampler2D uLast;\nout vec4 fColor;\nvoid main() {\n    ivec2 p = "
               "ivec2(gl_FragCoord.xy);\n"
               "    vec4 last = texelFetch(uLast, p, 0);\n" +
               statements +
               "\n    fColor = fract(last * 1.7 + vec4(p.x, p.y, 1, 1) * .037);\n}\nEndFragment\n" +
               "Program Next uLast heat.prev\nFragment inline\n#version 430 core\nuniform sampler2D uHeat;\n"
               "out vec4 fColor;\nvoid main() { fColor = texelFetch(uHeat, ivec2(gl_FragCoord.xy), 0); }\n"
               "EndFragment\nProgram Show uHeat heat\nStep 10\n    Repeat 3\n" +
               fill + "    EndRepeat\nEndStep\nFill window with Show\n";
    };
    const std::string fill = "        Fill heat with Next\n";
    EXPECT_EQ(copiesOf(scene("", fill)), 0U);
    EXPECT_EQ(copiesOf(scene("    if (p.x == 3) discard;", fill)), 10U);
    const std::string pass =
        "        Pass heat\n            Use Next\n            Vertices triangles 3\n"
        "        EndPass\n";
    EXPECT_EQ(copiesOf(scene("", pass)), 10U);
}

}  // namespace
}  // namespace glibra::test
