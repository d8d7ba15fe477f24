// Whether an animation is worth dividing, decided without a context, and how the diagnostics of its parts are
// joined.

#include "render/file/scene_inputs.h"

#include <gtest/gtest.h>

#include "scene_text.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

using render::AnimationRemarks;

const std::map<std::string, std::string> kAnimationFiles{
    {"a.vert", "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"},
    {"still.frag", "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(1.); }\n"},
    {"timer.frag", "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(Timer); }\n"},
    {"including.frag",
     "#version 330 core\nout vec4 f;\n#include \"still.glsl\"\n# include \"none.glsl\"\n#include "
     "\"wave.glsl\"\nvoid main() { f = vec4(wave()); }\n"},
    {"still.glsl", "#include \"including.frag\"\n"},
    {"wave.glsl", "float wave() { return sin(Timer); }\n"}};

/// 100 frames, ten per second, of which at most 60 are counted.
int differentFrames(const std::string& scene, bool skip = true) {
    const SceneFolder folder(scene, kAnimationFiles);
    RenderOptions options;
    options.skip = skip;
    return render::mostDifferentFrames(folder / "scene.glib", options, 100, 10, 60);
}

TEST(DifferentFrames, AreOneWithoutTimer) {
    EXPECT_EQ(differentFrames("Teapot\n"), 1);
    EXPECT_EQ(differentFrames("Timer 5\nVertex a.vert\nFragment still.frag\nProgram P\nTeapot\n"), 1);
    EXPECT_EQ(differentFrames("Vertex a.vert\nFragment timer.frag\nProgram P\n"), 1)
        << "nothing is drawn with it";
    EXPECT_EQ(differentFrames("Teapot\n", false), 60) << "nothing is to be skipped";
}

TEST(DifferentFrames, AreThoseOfAPeriod) {
    const std::string rest = "Vertex a.vert\nFragment timer.frag\nProgram P\nTeapot\n";
    EXPECT_EQ(differentFrames("Timer 2\n" + rest), 20);
    EXPECT_EQ(differentFrames("Timer 100\n" + rest), 60);
    EXPECT_EQ(differentFrames("Timer 2\n" + rest + "Timer .5\nTeapot\n"), 20);
    EXPECT_EQ(differentFrames("Timer 2\n" + rest + "Timer 3\nTeapot\n"), 60);
}

TEST(DifferentFrames, AreFoundThroughIncludedFiles) {
    EXPECT_EQ(differentFrames("Timer 2\nVertex a.vert\nFragment including.frag\nProgram P\nTeapot\n"), 20);
}

TEST(DifferentFrames, OfTwoProgramsWithOneFileAreThoseOfBoth) {
    EXPECT_EQ(differentFrames("Timer 2\nVertex a.vert\nFragment timer.frag\nProgram P\nProgram Q\nTeapot\n"),
              20);
}

TEST(DifferentFrames, OfAWrongSceneAreOne) {
    EXPECT_EQ(differentFrames("Program {\n"), 1);
    EXPECT_EQ(render::mostDifferentFrames("/no/such.glib", {}, 100, 10, 60), 1);
}

Diagnostic nan(int line, const std::string& text) {
    return diagnose("draw-W06", text, {"s.glib", line, 1});
}

TEST(JoinedRemarks, AreThoseOfTheFirstFrame) {
    const Diagnostic load = diagnose("glib-W01", "load", {"s.glib", 2, 1});
    const Diagnostic write = diagnose("file-E10", "write");
    const AnimationRemarks even{{load}, {{2, {nan(5, "2a"), nan(5, "2b")}}, {4, {nan(7, "4")}}}};
    const AnimationRemarks odd{{load, write}, {{1, {nan(7, "1")}}, {3, {nan(5, "3"), nan(9, "3")}}}};
    for (const auto& parts : {std::vector{even, odd}, std::vector{odd, even}}) {
        const Diagnostics all = render::joined(parts);
        ASSERT_EQ(all.size(), 6U) << text(all);
        EXPECT_EQ(text({all[2], all[3], all[4], all[5]}),
                  text({nan(7, "1"), nan(5, "2a"), nan(5, "2b"), nan(9, "3")}));
    }
}

TEST(JoinedRemarks, EndWithTheFirstFrameThatIsWrong) {
    Diagnostic wrong = nan(5, "3");
    wrong.severity = Severity::error;
    const Diagnostics all =
        render::joined({{{}, {{0, {nan(3, "0")}}, {4, {nan(9, "4")}}}}, {{}, {{3, {wrong}}}}});
    EXPECT_EQ(text(all), text({nan(3, "0"), wrong}));
}

}  // namespace
}  // namespace glibra::test
