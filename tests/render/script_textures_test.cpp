// Textures of modern scenes, by scenes whose Expect lines must hold.

#include <gtest/gtest.h>

#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

// ---- Pictures that shaders write.

/// Adds a tenth to each texel of the picture `map`, in `block` (Step or the frame).
std::string growing(const std::string& block) {
    return R"(WindowSize 4 4
Texture2D map grey.bmp nearest
Compute inline
#version 430
layout(local_size_x = 5, local_size_y = 3) in;
layout(rgba8) uniform image2D uImage;
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(uImage, at, imageLoad(uImage, at) + vec4(.1));
}
EndCompute
Program Grow uImage map
)" + showing("sampler2D", "vST") +
           "Program Show uT map\n" + block + "Fill window with Show\n";
}

TEST(WrittenPictures, BeginAsTheirFileSays) {
    const std::map<std::string, std::string> files{{"grey.bmp", bmp(5, 3, "\x33\x33\x33")}};
    const auto reds = [&](const std::string& block, const std::vector<double>& times, bool skips = true) {
        const SceneFolder folder(growing(block), files);
        render::Stats stats;
        RenderOptions options;
        options.skip = skips;
        auto scene = render::SceneRenderer::load(sharedContext(), folder / "scene.glib", options, stats);
        EXPECT_TRUE(scene) << text(scene.diagnostics);
        std::vector<int> found;
        for (const double time : times) {
            if (!scene) break;
            const Result<image::Image> picture = scene->draw(time, stats);
            EXPECT_TRUE(picture) << text(picture.diagnostics);
            found.push_back(picture ? std::to_integer<int>(picture->data.front()) : -1);
        }
        found.resize(times.size());
        return found;
    };
    // .2 in the file; each step adds 25.5 of 255, which is rounded to 26 or stored exactly.
    const std::vector<int> steps = reds("Step 1\n    Dispatch Grow over map\nEndStep\n", {0, 2, 3, 1, 0, 2});
    EXPECT_EQ(steps[0], 51);
    EXPECT_NEAR(steps[1], 102, 1);
    EXPECT_NEAR(steps[2], 128, 2);
    EXPECT_NEAR(steps[3], 76.5, 1) << "going back begins anew";
    EXPECT_EQ(steps[4], 51);
    EXPECT_EQ(steps[5], steps[1]);
    for (const bool skips : {true, false}) {
        const std::vector<int> frames = reds("Dispatch Grow over map\n", {0, 1, 2}, skips);
        EXPECT_NEAR(frames[0], 76.5, 1);
        EXPECT_EQ(frames, std::vector<int>(3, frames[0])) << "a frame leaves nothing to the next one";
    }
}

// ---- Parts of textures.

TEST(TextureParts, CanStandOnTheProgramLine) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nTexture2DArray arr 4 4 3 rgba8\n" + showing("sampler2D", "vST") +
                         R"(Program Show uT arr.layer(1)
Pass arr.layer(0) clear {1 0 0}
EndPass
Pass arr.layer(1) clear {0 1 0}
EndPass
Fill window with Show
Expect pixel 3 3 [0 1 0]
)"),
              "");
}

TEST(TextureParts, IncludeSingleLayersOf3DTextures) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nTexture3D vol 4 4 4 rgba8 nearest\n" + showing("sampler2D", "vST") +
                         R"(Program Show uT vol.layer(2)
Pass vol.layer(2) clear {0 1 0}
EndPass
Pass vol.layer(3) clear {0 0 1}
EndPass
Fill window with Show
Pass vol.layer(2) clear {1 1 0}
EndPass
Texture2D second 4 4 rgba8
Fill second with Show
Fill vol.layer(3) with Show
Expect pixel 3 3 [0 1 0]
Expect pixel 3 3 [1 1 0] of second
Expect pixel 3 3 [1 1 0] of vol.layer(3)
)"),
              "");
}

TEST(PictureLayers, AreTheFilesInOrder) {
    const std::map<std::string, std::string> files{{"red.bmp", bmp(5, 3, {0, 0, '\xff'})},
                                                   {"green.bmp", bmp(5, 3, {0, '\xff', 0})},
                                                   {"large.bmp", bmp(6, 3, {0, 0, 0})}};
    const std::string head =
        "WindowSize 8 8\nTexture2DArray arr red.bmp green.bmp nearest\n"
        "Texture2DArray one green.bmp\nTexture3D vol green.bmp red.bmp red.bmp nearest\n";
    EXPECT_EQ(problemsOf(head + showing("sampler2DArray", "vec3(vST, 1.)") + "Program Show uT arr\n" +
                             showing("sampler3D", "vec3(vST, .17)") + "Program Slice uT vol\n" +
                             showing("sampler2D", "vST") + R"(Program Layer uT one.layer(0)
Texture2D slice 8 8 rgba8
Texture2D layer 8 8 rgba8
Fill window with Show
Fill slice with Slice
Fill layer with Layer
Expect pixel 3 3 [0 1 0]
Expect pixel 3 3 [0 1 0] of slice
Expect pixel 3 3 [0 1 0] of layer
Expect (arr.size == vec3(5, 3, 2) && vol.size == vec3(5, 3, 3) && one.size == vec3(5, 3, 1))
)",
                         files),
              "");
    EXPECT_NE(
        problemsOf("Texture2DArray arr red.bmp large.bmp\n" + showing("sampler2DArray", "vec3(vST, 1.)") +
                       "Program Show uT arr\nFill window with Show\n",
                   files)
            .find("file-E06"),
        std::string::npos);
    EXPECT_NE(problemsOf("Texture2DArray arr red.bmp green.bmp\n" + showing("sampler2D", "vST") +
                             "Program Show uT arr.layer(2)\nFill window with Show\n",
                         files)
                  .find("not between 0 and 1"),
              std::string::npos);
}

// ---- Stencil.

TEST(Stencil, NeedsAFormatThatHasOne) {
    const std::string scene = "Texture2D color 8 8 rgba8\nTexture2D depth 8 8 depth24\nPass color depth";
    for (const char* rest : {" clear stencil 1\nEndPass\n", "\nState mark 1\nEndPass\n",
                             "\nState stencil equal 1\nEndPass\n", "\nClear stencil\nEndPass\n"}) {
        const std::string problems = problemsOf(scene + rest);
        EXPECT_NE(problems.find("glib-E38"), std::string::npos) << rest << problems;
        EXPECT_NE(problems.find("depth24_stencil8"), std::string::npos) << rest << problems;
    }
}

TEST(WrittenPictures, ThatASamplerReadsAreReported) {
    const auto found = [](const std::string& options, const std::string& qualifier, const std::string& tags) {
        return problemsOf(
            "Texture2D pic 8 8 rgba8 nearest " + options +
            "\nCompute inline\n#version 430\nlayout(local_size_x = 8, local_size_y = 8) in;\n"
            "layout(rgba8) uniform " +
            qualifier +
            " image2D uOut;\nuniform sampler2D uIn;\nvoid main() {\n"
            "ivec2 at = ivec2(gl_GlobalInvocationID.xy);\nvec4 c = texelFetch(uIn, (at + 1) % 8, 0);\n" +
            (qualifier == "readonly" ? "if (imageLoad(uOut, at) == c) at.x = 0;\n"
                                     : "imageStore(uOut, at, c);\n") +
            "}\nEndCompute\nProgram Blur " + tags + "\nOnce\nClear pic\nDispatch Blur over pic\nEndOnce\n" +
            showing("sampler2D", "vST") + "Program Show uT pic\nFill window with Show\n");
    };
    const std::string said =
        "warning: Dispatch: sampler 'uIn' reads 'pic' while image 'uOut' writes it; unless each invocation "
        "reads only "
        "the texel that it writes, declare 'pic' with history and read 'pic.prev' [draw-W12]";
    EXPECT_NE(found("", "writeonly", "uIn pic uOut pic").find(said), std::string::npos)
        << found("", "writeonly", "uIn pic uOut pic");
    EXPECT_EQ(found("history", "writeonly", "uIn pic.prev uOut pic").find("draw-W12"), std::string::npos);
    EXPECT_EQ(found("levels 2", "writeonly", "uIn pic.level(0) uOut pic.level(1)").find("draw-W12"),
              std::string::npos);
    EXPECT_EQ(found("", "readonly", "uIn pic uOut pic").find("draw-W12"), std::string::npos);
}

}  // namespace
}  // namespace glibra::test
