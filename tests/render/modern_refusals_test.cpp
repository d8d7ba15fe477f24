// Modern scenes that cannot be drawn, and those that look like it: what is read while it is written, cycles
// of passes, frames that write what lasts.

#include <string>

#include "modern_text.h"

namespace glibra::test {
namespace {

constexpr const char* kAddScene = R"(WindowSize 4 4
Fragment inline
#version 330 core
in vec2 vST;
uniform sampler2D uMap;
uniform float uAdd;
out vec4 fColor;
void main() { fColor = texture(uMap, vST) + vec4(uAdd); }
EndFragment
Program Add
)";  // ten lines

TEST(ModernRefusals, ReadingWhatIsWrittenNamesHistory) {
    const std::string found = refusalOf(std::string(kAddScene) +
                                        "Texture2D map 4 4 rgba8\nFill map with Add uMap map uAdd .2\n"
                                        "Fill window with Add uMap map uAdd 0\n");
    EXPECT_NE(found.find("scene.glib:12:"), std::string::npos) << found;
    EXPECT_NE(found.find("draw-E01"), std::string::npos) << found;
    EXPECT_NE(found.find("history"), std::string::npos) << found;
    EXPECT_EQ(found.find('\n'), found.size() - 1) << "one message: " << found;
    // Another level of the texture is another part, and so is what it was before.
    TextScene parts(std::string(kAddScene) +
                    "Texture2D map 8 8 rgba8 nearest_mipmap_nearest levels 2\nFill map with Add uMap "
                    "map.level(1) uAdd .2\n"
                    "Fill map.level(1) with Add uMap map.level(0) uAdd .2\nFill window with Add uMap "
                    "map.level(1) uAdd 0\n");
    EXPECT_EQ(byteAt(parts.draw(), 1, 1), 102);
    TextScene before(std::string(kAddScene) +
                     "Texture2D map 4 4 rgba8 history\nFill map with Add uMap map.prev uAdd .2\n"
                     "Fill map with Add uMap map.prev uAdd .4\nFill window with Add uMap map uAdd 0\n");
    EXPECT_EQ(byteAt(before.draw(), 1, 1), 153);
}

TEST(ModernRefusals, PassesThatReadEachOtherRunInTheOrderOfTheText) {
    // The first reads what nothing has written yet, in every frame.
    TextScene scene(std::string(kAddScene) +
                    "Texture2D a 4 4 rgba8\nTexture2D b 4 4 rgba8\nFill a with Add uMap b uAdd .2\n"
                    "Fill b with Add uMap a uAdd (.4 + 0 * time)\nFill a with Add uMap b uAdd .2\n"
                    "Fill window with Add uMap a uAdd 0\n");
    for (const double time : {0., 1., 2., 0.}) EXPECT_EQ(byteAt(scene.draw(time), 2, 2), 204) << time;
}

TEST(ModernRefusals, AFrameThatWritesWhatLastsNamesStep) {
    const std::string declared = std::string(kAddScene) + "Texture2D map 4 4 rgba8 history\n";
    for (const char* block : {"Once", "Step 10"}) {
        const std::string word = std::string(block).substr(0, 4);
        const std::string found =
            refusalOf(declared + block + "\nFill map with Add uMap map.prev uAdd .2\nEnd" + word +
                      "\nFill map with Add uMap map.prev uAdd .2\n"
                      "Fill window with Add uMap map uAdd 0\n");
        EXPECT_NE(found.find("scene.glib:15:"), std::string::npos) << found;
        EXPECT_NE(found.find("memory-E07"), std::string::npos) << found;
        EXPECT_NE(found.find("Step"), std::string::npos) << found;
        EXPECT_EQ(found.find('\n'), found.size() - 1) << "one message: " << found;
    }
}

TEST(ModernRefusals, ADrawWhoseShaderMayWriteWhatLastsIsNamedByItsLine) {
    const std::string declared =
        "Buffer place vec2 8\nCompute inline\n#version 430\nlayout(std430) buffer Place { vec2 place[]; };\n"
        "layout(local_size_x = 8) in;\nvoid main() { place[gl_GlobalInvocationID.x] += .01; }\nEndCompute\n"
        "Program Move\nVertex inline\n#version 430\nlayout(std430) buffer Place { vec2 place[]; };\n"
        "void main() { gl_Position = vec4(place[gl_VertexID], 0., 1.); }\nEndVertex\nFragment inline\n"
        "#version 430\nout vec4 c;\nvoid main() { c = vec4(1.); }\nEndFragment\nProgram Points\nStep 10\n"
        "    Dispatch Move over place\nEndStep\n";
    const std::string plain = refusalOf(declared + "Vertices points 8\n");
    EXPECT_NE(plain.find("scene.glib:23:1:"), std::string::npos) << plain;
    EXPECT_NE(plain.find("declare it readonly"), std::string::npos) << plain;
    const std::string inPass = refusalOf(declared + "Pass window\nSphere 1\nVertices points 8\nEndPass\n");
    EXPECT_NE(inPass.find("scene.glib:24:1:"), std::string::npos) << inPass;
}

TEST(ModernRefusals, AnExpressionWithoutAValueIsReportedForTheFrameThatHasNone) {
    const SceneFolder folder(
        std::string(kAddScene) +
        "Texture2D map 4 4 rgba8\nFill window with Add uMap map uAdd (1 / (time - 1))\n");
    render::Stats stats;
    auto loaded = render::SceneRenderer::load(sharedContext(), folder / "scene.glib", {}, stats);
    ASSERT_TRUE(loaded) << text(loaded.diagnostics);
    EXPECT_TRUE(loaded->draw(.5, stats));
    const auto failed = loaded->draw(1, stats);
    EXPECT_FALSE(failed);
    EXPECT_NE(text(failed.diagnostics).find("12:37: error: '1 / (time - 1)': division by zero"),
              std::string::npos)
        << text(failed.diagnostics);
    EXPECT_TRUE(loaded->draw(3.5, stats));
}

}  // namespace
}  // namespace glibra::test
