// What scenes drawn one after another share, and frames that cannot differ: nothing is made twice, and every
// picture equals that of a separate process.

#include "render/load/shared_parts.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "render/file/job.h"
#include "render/scene_renderer.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

using render::SharedParts;

const std::map<std::string, std::string> kSharedFiles{
    {"a.vert",
     "#version 330 core\nout vec3 vST;\nvoid main() { vST = aTexCoord0.stp; gl_Position = "
     "uModelViewProjectionMatrix * aVertex; }\n"},
    {"a.frag",
     "#version 330 core\nin vec3 vST;\nuniform vec3 uColor;\nuniform float uMore = .25;\nout vec4 fColor;\n"
     "void main() { fColor = vec4(uColor * texture(Noise3, vST).r + uMore, 1.); }\n"},
    {"timer.frag",
     "#version 330 core\nin vec3 vST;\nout vec4 fColor;\nvoid main() { fColor = vec4(vST.st, Timer, 1.); "
     "}\n"}};
const std::string kSharedStart =
    "WindowSize 64 48\nLookAt 0 0 4  0 0 0  0 1 0\nVertex a.vert\nFragment a.frag\n";

/// The same folder with another scene: the files keep their names.
Drawing drawText(const SceneFolder& folder, const std::string& scene, SharedParts* shared,
                 const RenderOptions& options = {}) {
    folder.write("scene.glib", scene);
    return draw(folder, options, shared);
}

TEST(SharedParts, ASecondSceneMakesNothingThatTheFirstHas) {
    const SceneFolder folder("", kSharedFiles);
    SharedParts shared;
    const std::string first = kSharedStart + "Program P uColor 1. .5 .2\nSphere 1 20 20\nTeapot\n";
    const Drawing before = drawText(folder, first, &shared);
    EXPECT_EQ(before.calls.programsLinked, 1U);
    const std::string second = kSharedStart + "Program P uColor 0. .5 .9\nTranslate .5 0 0\nTeapot\n";
    const Drawing after = drawText(folder, second, &shared);
    EXPECT_EQ(after.calls.programsLinked, 0U);
    EXPECT_EQ(after.calls.bytesUploaded, 0U);
    EXPECT_EQ(after.count("programs kept") + after.count("meshes kept") + after.count("textures kept"), 3U);
    EXPECT_EQ(after.skipped("program"), std::vector<std::string>{"'P': already linked"});
    EXPECT_EQ(after.skipped("mesh").front(), "Teapot: already on the device");
    EXPECT_TRUE(after.pixels == drawText(folder, second, nullptr).pixels);
    EXPECT_TRUE(drawText(folder, first, &shared).pixels == before.pixels);
}

TEST(SharedParts, TheSameSceneAgainIsNotEvenTranslated) {
    const SceneFolder folder("", kSharedFiles);
    SharedParts shared;
    const std::string scene = kSharedStart + "Program P uColor 1. .5 .2\nSphere 1 20 20\n";
    const Drawing first = drawText(folder, scene, &shared);
    const Drawing again = drawText(folder, scene, &shared);
    EXPECT_EQ(again.count("translations kept"), 1U);
    EXPECT_EQ(again.calls.bytesUploaded + again.calls.programsLinked, 0U);
    EXPECT_TRUE(first.pixels == again.pixels);
}

TEST(SharedParts, ValuesOfOneSceneDoNotReachTheNext) {
    const SceneFolder folder("", kSharedFiles);
    SharedParts shared;
    const std::string bright = kSharedStart + "Program P uColor 1. .5 .2 uMore .6\nSphere 1 20 20\n";
    const std::string plain = kSharedStart + "Program P uColor 1. .5 .2\nSphere 1 20 20\n";
    const Drawing alone = drawText(folder, plain, nullptr);
    const Drawing brightAlone = drawText(folder, bright, nullptr);
    ASSERT_FALSE(alone.pixels == brightAlone.pixels);
    RenderOptions set;
    set.set = {"uMore=.9"};
    for (int round = 0; round < 2; ++round) {
        EXPECT_TRUE(drawText(folder, bright, &shared).pixels == brightAlone.pixels);
        EXPECT_TRUE(drawText(folder, plain, &shared).pixels == alone.pixels);
        EXPECT_FALSE(drawText(folder, plain, &shared, set).pixels == alone.pixels);
        EXPECT_TRUE(drawText(folder, plain, &shared).pixels == alone.pixels);
    }
}

TEST(SharedParts, AFileThatChangedIsReadAgain) {
    const SceneFolder folder("", kSharedFiles);
    SharedParts shared;
    const std::string scene = kSharedStart + "Program P uColor 1. .5 .2\nObj m.obj\n";
    folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    drawText(folder, scene, &shared);
    folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1.5 0\nf 1 2 3\n");
    folder.write(
        "a.frag",
        "#version 330 core\nin vec3 vST;\nuniform vec3 uColor;\nout vec4 fColor;\nvoid main() { fColor = "
        "vec4(uColor, 1.); }\n");
    const Drawing changed = drawText(folder, scene, &shared);
    EXPECT_EQ(changed.calls.programsLinked, 1U);
    EXPECT_GT(changed.calls.buffersFilled, 0U);
    EXPECT_TRUE(changed.pixels == drawText(folder, scene, nullptr).pixels);
}

TEST(SharedParts, AModelFirstSeenWithoutTangentsGetsThemWhenTheyAreRead) {
    auto files = kSharedFiles;
    files["t.vert"] =
        "#version 330 core\nout vec3 vST;\nvoid main() { vST = abs(aTangent) + .2; gl_Position = "
        "uModelViewProjectionMatrix * aVertex; }\n";
    files["m.obj"] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n";
    files["b.frag"] =
        "#version 330 core\nin vec3 vST;\nout vec4 fColor;\nvoid main() { fColor = vec4(vST, 1.); }\n";
    const SceneFolder folder("", files);
    SharedParts shared;
    const std::string start = "WindowSize 64 48\nLookAt 0 0 4  0 0 0  0 1 0\nFragment b.frag\n";
    drawText(folder, start + "Vertex a.vert\nProgram A\nObj m.obj\n", &shared);
    const std::string both =
        start +
        "Vertex a.vert\nProgram A\nObj m.obj\nVertex t.vert\nProgram T\nTranslate -1 0 0\nObj m.obj\n";
    EXPECT_TRUE(drawText(folder, both, &shared).pixels == drawText(folder, both, nullptr).pixels);
}

TEST(SharedParts, RemarksAreHeardByEveryScene) {
    auto files = kSharedFiles;
    files["m.obj"] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n";
    const SceneFolder folder("", files);
    SharedParts shared;
    const std::string scene = kSharedStart + "Program P uColor 1. .5 .2\nObj m.obj\n";
    const Drawing first = drawText(folder, scene, &shared);
    ASSERT_FALSE(first.diagnostics.empty());
    EXPECT_EQ(drawText(folder, scene, &shared).diagnostics.size(), first.diagnostics.size());
}

TEST(SharedParts, TheLeastUsedGoFirstWhenThereIsTooMuch) {
    render::PartStore<int> store(10);
    store.add("a", 1, 4);
    store.add("b", 2, 4);
    EXPECT_TRUE(store.find("a"));
    store.add("c", 3, 4);
    EXPECT_FALSE(store.find("b"));
    EXPECT_TRUE(store.find("a"));
    EXPECT_EQ(store.size(), 8U);
    store.add("d", 4, 11);
    EXPECT_FALSE(store.find("d"));
    EXPECT_EQ(store.take("a"), 1);
    EXPECT_EQ(store.take("a"), std::nullopt);
    EXPECT_EQ(store.size(), 4U);
}

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct Frames {
    std::vector<std::string> files;
    std::uint64_t draws = 0;
    std::string explanation;
};
Frames animate(const SceneFolder& folder, int frames, double framesPerSecond, bool skip) {
    render::Job job;
    job.scene = folder / "scene.glib";
    job.output = folder / "f.png";
    job.frames = frames;
    job.framesPerSecond = framesPerSecond;
    job.options.skip = skip;
    job.explain = true;
    Frames result;
    int told = 0;
    gpu::Context& context = sharedContext();
    const render::JobResult done = render::runJob(context, job, [&](int written) { told = written; });
    EXPECT_FALSE(done.failed);
    EXPECT_EQ(told, frames);
    const std::size_t at = done.explanation.find("GL draws");
    result.draws = std::stoul(done.explanation.substr(at + 8));
    result.explanation = done.explanation;
    for (int i = 0; i < frames; ++i)
        result.files.push_back(bytesOf(render::frameFile(job.output, i, frames)));
    EXPECT_FALSE(result.files.front().empty());
    return result;
}

/// Draws the same frames by several jobs; returns how many files each of them wrote.
std::vector<int> animateInParts(const SceneFolder& folder, int frames, double framesPerSecond, int parts,
                                std::vector<std::string>& files) {
    render::Job job;
    job.scene = folder / "scene.glib";
    job.output = folder / "p.png";
    job.frames = frames;
    job.framesPerSecond = framesPerSecond;
    job.parts = parts;
    std::vector<int> written(static_cast<std::size_t>(parts));
    for (job.part = 0; job.part < parts; ++job.part) {
        int& told = written[static_cast<std::size_t>(job.part)];
        EXPECT_FALSE(render::runJob(sharedContext(), job, [&](int count) { told = count; }).failed);
    }
    for (int i = 0; i < frames; ++i) files.push_back(bytesOf(render::frameFile(job.output, i, frames)));
    return written;
}

TEST(Frames, WithoutTimerAreDrawnOnce) {
    const SceneFolder folder(kSharedStart + "Program P uColor 1. .5 .2\nSphere 1 20 20\n", kSharedFiles);
    const Frames skipping = animate(folder, 12, 10, true);
    const Frames whole = animate(folder, 12, 10, false);
    EXPECT_EQ(skipping.draws, 1U);
    EXPECT_EQ(whole.draws, 12U);
    EXPECT_TRUE(skipping.files == whole.files);
    EXPECT_NE(skipping.explanation.find("11 of 12 are copies of the first: no draw reads Timer"),
              std::string::npos);
}

TEST(Frames, OfARepeatedPeriodAreDrawnOnce) {
    const SceneFolder folder(
        "Timer 1\nWindowSize 64 48\nLookAt 0 0 4  0 0 0  0 1 0\nVertex a.vert\nFragment timer.frag\nProgram "
        "P\nQuadXY 0 1\n",
        kSharedFiles);
    const Frames skipping = animate(folder, 24, 8, true);
    const Frames whole = animate(folder, 24, 8, false);
    EXPECT_EQ(skipping.draws, 8U);
    EXPECT_EQ(whole.draws, 24U);
    EXPECT_TRUE(skipping.files == whole.files);
    EXPECT_NE(skipping.files[0], skipping.files[1]);
    std::vector<std::string> divided;
    // On a GPU, one process draws all.
    const bool isSoftware = sharedContext().capabilities().isSoftware;
    EXPECT_EQ(animateInParts(folder, 24, 8, 3, divided),
              isSoftware ? (std::vector{9, 9, 6}) : (std::vector{24, 0, 0}))
        << "3, 3 and 2 of the 8 that differ";
    EXPECT_TRUE(divided == whole.files);
}

TEST(Frames, ThatReadATextureOfTheFrameBeforeAreAllDrawn) {
    auto files = kSharedFiles;
    files["grow.frag"] =
        "#version 330 core\nin vec3 vST;\nuniform sampler2D uLast;\nout vec4 fColor;\n"
        "void main() { fColor = vec4(texture(uLast, vST.st).rgb + .05, 1.); }\n";
    const std::string start =
        "WindowSize 64 48\nLookAt 0 0 2  0 0 0  0 1 0\nTexture2D 7 16 16\nTexture2D 8 16 16\nVertex "
        "a.vert\nFragment grow.frag\n";
    // Texture 8 shows texture 7 of this frame, and 7 is made from 8 of the previous frame.
    const SceneFolder folder(
        start +
            "RenderToTexture 7\nProgram A uLast 8\nQuadXY 0 3\nRenderToTexture 8\n"
            "Program B uLast 7\nQuadXY 0 3\nRenderToTexture\nProgram C uLast 8\nQuadXY 0 1\n",
        files);
    const Frames skipping = animate(folder, 4, 10, true);
    const Frames whole = animate(folder, 4, 10, false);
    EXPECT_EQ(skipping.draws, 12U);
    EXPECT_TRUE(skipping.files == whole.files);
    EXPECT_NE(skipping.files[1], skipping.files[2]);
    std::vector<std::string> divided;
    EXPECT_EQ(animateInParts(folder, 4, 10, 2, divided), (std::vector{4, 0})) << "one draws them all";
    EXPECT_TRUE(divided == whole.files);
    // Without the feedback every frame is the same.
    const SceneFolder straight(
        start +
            "RenderToTexture 8\nProgram B uLast 5\nQuadXY 0 3\nRenderToTexture\nProgram C "
            "uLast 8\nQuadXY 0 1\n",
        files);
    EXPECT_EQ(animate(straight, 4, 10, true).draws, 2U);
}

}  // namespace
}  // namespace glibra::test
