// What scripts state about themselves: each scene here has Expect lines, which must hold.

#include <gtest/gtest.h>

#include <string>

#include "render/check/answers.h"
#include "render/scene_renderer.h"
#include "scene_text.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

/// The messages of drawing a scene and answering its checks; empty if all is well.
std::string problemsOf(const std::string& scene, const std::map<std::string, std::string>& files = {},
                       const RenderOptions& options = {}) {
    const SceneFolder folder(scene, files);
    return text(render::runChecks(sharedContext(), folder / "scene.glib", options));
}

/// A BMP picture of one colour, as blue, green, red.
std::string bmp(int width, int height, const std::string& color) {
    const auto number = [](int value) {
        std::string bytes;
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
        return bytes;
    };
    std::string row;
    for (int x = 0; x < width; ++x) row += color;
    row.resize((row.size() + 3) / 4 * 4);
    std::string rows;
    for (int y = 0; y < height; ++y) rows += row;
    return "BM" + number(54 + static_cast<int>(rows.size())) + number(0) + number(54) + number(40) +
           number(width) + number(height) + std::string("\1\0\30\0", 4) + number(0) +
           number(static_cast<int>(rows.size())) + number(0) + number(0) + number(0) + number(0) + rows;
}

/// A program that shows the colour of the sampler `uT`, of this type, at these coordinates.
std::string showing(const std::string& type, const std::string& at) {
    return "Fragment inline\n#version 330\nin vec2 vST;\nout vec4 c;\nuniform " + type +
           " uT;\nvoid main() { c = texture(uT, " + at + "); }\nEndFragment\n";
}

TEST(ScriptChecks, LevelsAreGeneratedForTheCheck) {
    EXPECT_EQ(problemsOf(R"(WindowSize 8 8
Texture2D a 8 8 rgba8 mipmap levels 4 generate
Fragment inline
#version 430
in vec2 vST; out vec4 c; void main(){ c=vec4(vST.x<.5,0,0,1); }
EndFragment
Program P
Fill a with P
Expect pixel 0 0 [.5] of a.level(3) within .01
)"),
              "");
}

TEST(ScriptChecks, AConditionThatFailsShowsBothSides) {
    const auto found = [](const std::string& check) {
        const std::string problems = problemsOf(
            "Buffer sums uint [40 26 96]\nLet aim <0 3 9>\nFragment inline\n"
            "#version 430\nlayout(std430) buffer sums { uint n[]; };\nout vec4 c;\n"
            "void main() { c = vec4(n[0]); }\nEndFragment\nProgram P\nUse P\n"
            "FullScreen\nExpect " +
            check + "\n");
        const std::size_t at = problems.find("expected true, found ");
        return at == std::string::npos ? problems : problems.substr(at + 21, problems.rfind(" [") - at - 21);
    };
    EXPECT_EQ(found("(sums[0] == 40)"), "");
    EXPECT_EQ(found("(sums[0] == 41)"), "40 == 41");
    EXPECT_EQ(found("(sums[1] + 1 <= aim * (2 + aim))"), "27 <= 15");
    EXPECT_EQ(found("(vec2(aim, 1) == vec2(1, 1))"), "[3 1] == [1 1]");
    EXPECT_EQ(found("(sums[0] == 40 && sums[1] == 2)"), "false");
    EXPECT_EQ(found("(aim - 3)"), "0");
    EXPECT_NE(found("primitives (sums[0])")
                  .find("'sums[0]' has no value here: only Expect (condition) reads the "
                        "elements of buffers"),
              std::string::npos);
}

TEST(ScriptChecks, EqualContentsMayDifferWithinATolerance) {
    const auto found = [](const std::string& check) {
        return problemsOf("Buffer a float [1 2 3]\nBuffer b float [1 2.25 3]\nExpect " + check + "\n");
    };
    EXPECT_EQ(found("same a b within .25"), "");
    EXPECT_EQ(found("different a b within .2"), "");
    EXPECT_NE(found("same a b within .2")
                  .find("expected the same content within 0.2, found 1 differing value, by up to 0.25"),
              std::string::npos)
        << found("same a b within .2");
    EXPECT_NE(
        found("different a b within .25").find("expected different content, found the same within 0.25"),
        std::string::npos);
}

TEST(ScriptChecks, AMisspeltSetIsReported) {
    const auto found = [](const std::string& set, const std::string& after = "FullScreen\n") {
        return problemsOf(
            "WindowSize 8 8\nFragment inline\n#version 430\nuniform vec4 uColor, uLight1; out vec4 c;\n"
            "layout(std430) buffer Sums { float sums[]; };\nvoid main() { c = uColor + uLight1; sums[0] = "
            "1.; }\n"
            "EndFragment\nBuffer sums float 1\nProgram P uColor {1 0 0} uLight1 {0 0 0 0}\n" +
            set + "\n" + after);
    };
    const std::string expected =
        "warning: no program of the scene has a uniform 'uClor'; did you mean 'uColor'?";
    EXPECT_NE(found("Set uClor {1 0 0 1}").find(expected), std::string::npos) << found("Set uClor {1 0 0 1}");
    EXPECT_NE(found("Set uClor {1 0 0 1}", "Once\nClear sums\nEndOnce\nFullScreen\n").find(expected),
              std::string::npos);
    EXPECT_EQ(found("Set uColor {1 0 0 1}"), "");
    EXPECT_EQ(found("Set uLight2 {1 0 0 1}"), "") << "it may be of a row that this scene does not need whole";
    EXPECT_EQ(found("Set uOther 5"), "") << "a Set is for all programs, and none of them need have it";
    EXPECT_EQ(found("Set Sums sums"), "");
    EXPECT_EQ(found("Set uClor {1 0 0 1}", "Program Q\nUse P\nFullScreen\n"), "") << "Q may have it";
}

TEST(ScriptChecks, OutputsFitTheirTargets) {
    const auto drawn = [](const std::string& output, const std::string& format,
                          const std::string& state = {}) {
        return problemsOf(
            "WindowSize 8 8\nTexture2D ids 8 8 " + format + "\nFragment inline\n#version 430\nout " + output +
            " c;\nvoid main() { c = " + output + "(7); }\nEndFragment\nProgram P\nPass ids\n" + state +
            "Use P\nFullScreen\nEndPass\nExpect pixel 2 2 [" + (state.empty() ? "7" : "0") + "] of ids\n");
    };
    EXPECT_EQ(drawn("uint", "r32ui"), "");
    EXPECT_EQ(drawn("int", "r8i"), "");
    EXPECT_EQ(drawn("float", "r32f"), "");
    EXPECT_NE(drawn("vec4", "r32ui")
                  .find("error: fragment output 'c' is of type vec4, but target 'ids' (line 2) "
                        "holds unsigned integers; declare the output as uvec4"),
              std::string::npos)
        << drawn("vec4", "r32ui");
    EXPECT_NE(drawn("uint", "r32i").find("holds signed integers; declare the output as int"),
              std::string::npos);
    EXPECT_NE(drawn("ivec2", "rg8").find("holds floating-point numbers; declare the output as vec2"),
              std::string::npos);
    EXPECT_EQ(drawn("vec4", "r32ui", "State write none\n"), "") << "nothing is written";
}

TEST(ScriptChecks, SmallBuffersLast) {
    EXPECT_EQ(problemsOf(R"(Buffer b float 1
Compute inline
#version 430
layout(local_size_x=1) in; layout(std430) buffer B { float b[]; };
void main(){ b[0]+=1.; }
EndCompute
Program C
Once
    Dispatch C 1
EndOnce
Expect buffer b [1]
)"),
              "");
}

TEST(ScriptChecks, KeepWhatIsReportedWithoutDrawing) {
    const SceneFolder folder("Sphere\nExpect error glib-W23\n");
    const Diagnostics known = {diagnose("glib-W23", "a"), diagnose("glib-W24", "b")};
    const std::string found = text(render::runChecks(sharedContext(), folder / "scene.glib", {}, known));
    EXPECT_EQ(found.find("glib-W23"), std::string::npos) << found;
    EXPECT_NE(found.find("glib-W24"), std::string::npos) << found;
}

TEST(ScriptChecks, ReportWhatDoesNotHold) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nPass window clear {1 0 0}\nEndPass\nExpect pixel 2 2 [1 0 0]\n"),
              "");
    EXPECT_NE(problemsOf("WindowSize 8 8\nPass window clear {1 0 0}\nEndPass\nExpect pixel 2 2 [0 1 0]\n")
                  .find("check-E01"),
              std::string::npos);
}

TEST(Choices, BindTheTextureOrBufferThatTheirWordNames) {
    const std::string begin =
        "WindowSize 8 8\nTexture2D red 8 8 rgba8\nTexture2D green 8 8 rgba8\nLet pic <green red>\n" +
        showing("sampler2D", "vST") +
        "Program Copy\nFragment inline\n#version 330\nin vec2 vST;\nout vec4 c;\nuniform sampler2D uT;\n"
        "void main() { c = texture(uT, vST); }\nEndFragment\nProgram Tagged uT pic\n"
        "Pass red clear {1 0 0}\nEndPass\nPass green clear {0 1 0}\nEndPass\n";
    const std::string isGreen = "Expect pixel 3 3 [0 1 0]\n";
    EXPECT_EQ(problemsOf(begin + "Fill window with Copy uT pic\n" + isGreen), "");
    EXPECT_EQ(problemsOf(begin + "Fill window with Tagged\n" + isGreen), "");
    EXPECT_EQ(problemsOf(begin + "Set uT pic\nFill window with Copy\n" + isGreen), "");
    EXPECT_EQ(
        problemsOf(begin + "Repeat [red green] as op\nFill window with Copy uT op\nEndRepeat\n" + isGreen),
        "");
    EXPECT_EQ(
        problemsOf(begin + "Group g what red\nFill window with Copy uT what\nEndGroup\nDraw g what pic\n" +
                   isGreen),
        "");
    EXPECT_EQ(problemsOf("WindowSize 8 8\nTexture2D red 8 8 rgba8\nTexture2D green 8 8 rgba8\n"
                         "Let pic <red green>\nFragment inline\n#version 330\nuniform int uK;\nout vec4 c;\n"
                         "void main() { c = vec4(0, uK == 1 ? 1 : 0, 0, 1); }\nEndFragment\nProgram Number\n"
                         "Repeat [red green] as op\nFill window with Number uK op\nEndRepeat\n" +
                         isGreen),
              "")
        << "other uniforms take the number";
    EXPECT_NE(problemsOf(begin + "Let other <one two>\nFill window with Copy uT other\n")
                  .find("'one' is no variable, texture or buffer"),
              std::string::npos);
}

TEST(Messages, OfATagWithAnErrorAreNotRepeated) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nTexture2D life 8 8 rgba8\n" + showing("sampler2D", "vST") +
                         "Program Next uT life.prev\nFill window with Next\nExpect error glib-E27\n"),
              "");
    const std::string time = problemsOf(
        "WindowSize 8 8\nLet k 1\nFragment inline\n#version 330\nuniform float time;\nout vec4 c;\n"
        "void main() { c = vec4(time + .5); }\nEndFragment\nProgram P\nFill window with P\n");
    EXPECT_NE(time.find("is not set; it is 0; write 'time (time)' on the line of its Program"),
              std::string::npos)
        << time;
}

TEST(Expressions, GoOnAfterABackslash) {
    EXPECT_EQ(
        problemsOf(
            "WindowSize 8 8\nLet pose[3] (i == 0 ? 2 \\ # (\n  : 3 \\  \r\n * pose[i - 1])  # the rest\n"
            "Let other (1 + ( \\\n 2)) \n"
            "Pass window clear \\\n (vec3(1, 0, \\\n 1))\nEndPass\n"
            "Expect (pose[2] == 18 \\\n && other == 3)\nExpect pixel 3 3 [1 0 1]\n"),
        "");
    const std::string problems = problemsOf("Let a (1 + \\\n   nonsense)\n");
    EXPECT_NE(problems.find(":2:4:"), std::string::npos) << problems;
    EXPECT_NE(problemsOf("Let a (1 + \n   2)\n").find("glib-E20"), std::string::npos);
}

// ---- Dispatches in pieces.

/// Each invocation of 7 x 5 x 3 groups of 2 x 2 x 1 writes where it is, and the number of groups.
std::string numbered(const std::string& dispatch) {
    return R"(Compute inline
#version 430
layout(local_size_x = 2, local_size_y = 2) in;
layout(std430) writeonly buffer Found { uint found[]; };
uint flat3(uvec3 at, uvec3 size) { return at.x + size.x * (at.y + size.y * at.z); }
void main() {
    uvec3 size = gl_NumWorkGroups * uvec3(2u, 2u, 1u);
    uint place = flat3(gl_GlobalInvocationID, size);
    found[place] = flat3(gl_WorkGroupID, gl_NumWorkGroups) * 4u + gl_LocalInvocationIndex;
}
EndCompute
Program Count
Buffer Found uint 420
)" + dispatch +
           "\n";
}

TEST(DispatchTiles, SeeTheNumbersOfTheWhole) {
    // Invocation (x, y, z) belongs to group (x / 2, y / 2, z).
    for (const char* tiles : {"", " tiles 1", " tiles 2", " tiles 3", " tiles 1000"}) {
        std::string scene = numbered(std::string("Dispatch Count 7 5 3") + tiles);
        for (int i = 0; i < 420; i += 23)
            scene += "Expect (Found[" + std::to_string(i) + "] == " +
                     std::to_string(4 * (i % 14 / 2 + 7 * (i / 14 % 10 / 2 + 5 * (i / 140))) + i % 2 +
                                    2 * (i / 14 % 2)) +
                     ")\n";
        EXPECT_EQ(problemsOf(scene), "") << tiles;
    }
}

TEST(DispatchTiles, GiveTheSameBytesAsOnePiece) {
    const auto scene = [](const std::string& tiles) {
        return R"(WindowSize 37 29
Texture2D image 37 29 rgba32f
Compute inline
#version 430
layout(local_size_x = 4, local_size_y = 4) in;
layout(rgba32f) uniform writeonly image2D uImage;
void main() {
    imageStore(uImage, ivec2(gl_GlobalInvocationID.xy),
               vec4(vec2(gl_WorkGroupID.xy) / vec2(gl_NumWorkGroups.xy), fract(float(gl_LocalInvocationIndex) / 7.), 1.));
}
EndCompute
Program Paint uImage image
)" + showing("sampler2D", "vST") +
               "Program Show uT image\nDispatch Paint over image" + tiles + "\nFill window with Show\n";
    };
    const Drawing whole = draw(SceneFolder(scene("")));
    const Drawing parts = draw(SceneFolder(scene(" tiles 5")));
    EXPECT_EQ(whole.pixels, parts.pixels);
    EXPECT_EQ(whole.count("pieces of dispatches"), 0U);
    EXPECT_EQ(parts.count("pieces of dispatches"), 5U);
}

// ---- Images with another format.

TEST(ImageFormats, OfEqualSizeReinterpretTexels) {
    EXPECT_EQ(problemsOf(R"(Texture2D bits 4 4 r32ui
Compute inline
#version 430
layout(local_size_x = 4, local_size_y = 4) in;
layout(r32f) uniform writeonly image2D uImage;
void main() { imageStore(uImage, ivec2(gl_GlobalInvocationID.xy), vec4(1.)); }
EndCompute
Program Write uImage bits
Dispatch Write over bits
Expect pixel 0 0 [1065353216] of bits
)"),
              "");
}

TEST(ImageFormats, OfAnotherSizeAreReportedOnce) {
    const std::string compute = R"(Texture2D bits 4 4 rgba8
Compute inline
#version 430
layout(local_size_x = 4, local_size_y = 4) in;
layout(rgba16f) uniform writeonly image2D uImage;
void main() { imageStore(uImage, ivec2(gl_GlobalInvocationID.xy), vec4(1.)); }
EndCompute
Program Write uImage bits
Dispatch Write over bits
)";
    const std::string fragment = R"(Texture2D bits 4 4 rgba8
Texture2D other 4 4 rgba8
Fragment inline
#version 430
layout(rgba16f) uniform writeonly image2D uImage;
out vec4 fColor;
void main() { imageStore(uImage, ivec2(gl_FragCoord.xy), vec4(1.)); fColor = vec4(1.); }
EndFragment
Program Write uImage bits
Fill other with Write
)";
    for (const std::string& scene : {compute, fragment})
        for (const bool skips : {true, false}) {
            RenderOptions options;
            options.skip = skips;
            const std::string problems =
                problemsOf(scene + "Expect pixel 0 0 [1 1 1 1] of bits\n", {}, options);
            const std::size_t first = problems.find("draw-E09");
            EXPECT_NE(first, std::string::npos) << problems;
            EXPECT_EQ(problems.find("draw-E09", first + 1), std::string::npos) << problems;
            EXPECT_NE(problems.find("scene.glib:"), std::string::npos) << problems;
            EXPECT_NE(problems.find("8 bytes, not 4"), std::string::npos) << problems;
        }
}

TEST(Dispatch, ThatWritesNothingReportsItsProgram) {
    const std::string problems = problemsOf(R"(Texture2D bits 4 4 rgba8
Compute inline
#version 430
layout(local_size_x = 4, local_size_y = 4) in;
layout(rgba8) uniform writeonly image2D uImage;
void main() { imageStore(uImage, ivec2(gl_GlobalInvocationID.xy), vec4(1.)); }
EndCompute
Program Write uImagge bits
Dispatch Write over bits
Expect pixel 0 0 [0 0 0 0] of bits
)");
    EXPECT_NE(problems.find("uniform 'uImagge'; did you mean 'uImage'?"), std::string::npos) << problems;
}

TEST(Dispatch, TagsMayResembleKeysIfTheProgramHasThem) {
    const std::string scene = R"(Buffer Found float 4
Compute inline
#version 430
layout(local_size_x = 1) in;
uniform float cover, tile;
layout(std430) writeonly buffer Found { float found[]; };
void main() { found[gl_GlobalInvocationID.x] = cover + tile; }
EndCompute
Program Write cover 0 tile 0
)";
    EXPECT_EQ(
        problemsOf(scene + "Dispatch Write 4 1 1 cover .5 tile .25\nExpect buffer Found [.75 .75 .75 .75]\n"),
        "");
    for (const char* rest : {"", "Expect buffer Found [0 0 0 0]\n"}) {
        const std::string problems = problemsOf(scene + "Dispatch Write 4 1 1 tilse 4\n" + rest);
        EXPECT_NE(
            problems.find("scene.glib:10:22: error: Dispatch: unknown word 'tilse'; did you mean 'tiles'?"),
            std::string::npos)
            << problems;
        EXPECT_EQ(problems.find("tilse"), problems.rfind("tilse")) << problems;
    }
    EXPECT_NE(problemsOf(scene + "Dispatch Write 4 1 1 form Found\n").find("did you mean 'from'?"),
              std::string::npos);
}

// ---- Subroutine uniforms.

TEST(Subroutines, AreChosenByTheNamesOfTheirFunctions) {
    const std::string shader = R"(Fragment inline
#version 400 core
subroutine vec4 Shade(float level);
subroutine uniform Shade shade;
subroutine(Shade) vec4 red(float level) { return vec4(level, 0., 0., 1.); }
subroutine(Shade) vec4 green(float level) { return vec4(0., level, 0., 1.); }
out vec4 fColor;
void main() { fColor = shade(1.); }
EndFragment
)";
    const std::string isGreen = "Expect pixel 1 1 [0 1 0]\n";
    for (const char* rest : {
             "Let some 1\nProgram P shade green\nFill window with P\n",
             "Let some 1\nProgram P shade red\nFill window with P shade green\n",
             "Program P shade 1\nFill window with P\n",
             "Let way <green red>\nProgram P shade way\nFill window with P\n",
             "Program P\nRepeat [red green] as which\n    Set shade which\n    Fill window with "
             "P\nEndRepeat\n",
         })
        EXPECT_EQ(problemsOf("WindowSize 4 4\n" + shader + rest + isGreen), "") << rest;
    RenderOptions options;
    options.set = {"shade=green"};
    for (const char* rest : {"Let shade <red green>\nProgram P\n", "Let some 1\nProgram P shade red\n"})
        EXPECT_EQ(
            problemsOf("WindowSize 4 4\n" + shader + rest + "Fill window with P\n" + isGreen, {}, options),
            "")
            << rest;
    options.set = {"shade=gren"};
    EXPECT_NE(problemsOf(shader + "Let some 1\nProgram P shade red\nFill window with P\n", {}, options)
                  .find("subroutine uniform 'shade' has no function 'gren'; did you mean 'green'?"),
              std::string::npos);
}

TEST(Subroutines, OfAStepAreChosenOnTheCommandLine) {
    const std::string scene = R"(WindowSize 4 4
Let some 1
Texture2D kept 4 4 rgba8 nearest
Fragment inline
#version 400 core
subroutine vec4 Shade(float level);
subroutine uniform Shade shade;
uniform float uLevel;
subroutine(Shade) vec4 red(float level) { return vec4(level, 0., 0., 1.); }
subroutine(Shade) vec4 green(float level) { return vec4(0., level, 0., 1.); }
out vec4 fColor;
void main() { fColor = shade(uLevel); }
EndFragment
Program P shade red uLevel (some)
Once
    Fill kept with P
EndOnce
Expect pixel 1 1 [0 1 0] of kept
)";
    RenderOptions options;
    for (const char* set : {"shade=green", "P:shade=green"}) {
        options.set = {set};
        EXPECT_EQ(problemsOf(scene, {}, options), "") << set;
    }
    options.set = {"shade=green", "uLevel=.5"};
    EXPECT_EQ(problemsOf(scene, {}, options).find("uLevel"), std::string::npos);
    options.set = {"shade=green", "uLvl=.5"};
    EXPECT_NE(problemsOf(scene, {}, options).find("has a uniform 'uLvl'"), std::string::npos);
    options.set = {"P:uLevel=green"};
    EXPECT_NE(problemsOf(scene, {}, options)
                  .find("--set P:uLevel=green: 'green' is not a number, and program 'P' has no subroutine "
                        "uniform 'uLevel'"),
              std::string::npos);
}

TEST(Subroutines, ReportFunctionsThatDoNotExist) {
    const std::string shader = R"(Let some 1
Fragment inline
#version 400 core
subroutine vec4 Shade(float level);
subroutine uniform Shade shade;
uniform float uLevel;
subroutine(Shade) vec4 red(float level) { return vec4(level, 0., 0., 1.); }
subroutine(Shade) vec4 green(float level) { return vec4(0., level, 0., 1.); }
out vec4 fColor;
void main() { fColor = shade(uLevel); }
EndFragment
)";
    const auto expect = [&](const std::string& program, const std::string& message) {
        const std::string problems = problemsOf(shader + program + "\nFill window with P\n");
        EXPECT_NE(problems.find(message), std::string::npos) << problems;
    };
    expect("Program P uLevel 1 shade gren",
           "12:26: error: subroutine uniform 'shade' has no function 'gren'; did you mean 'green'?");
    expect("Program P uLevel smoe shade green",
           "'smoe' is no variable, texture or buffer; did you mean 'some'?");
    expect("Program P uLevel 1", "5:26: warning: subroutine uniform 'shade' uses its first function 'red'");
}

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

// ---- Vertices.

constexpr const char* kCornerProgram = R"(WindowSize 8 8
Texture2D target 8 8 rgba8
Vertex inline
#version 330
void main() { gl_Position = vec4(float(gl_VertexID & 1) * 2. - 1., float(gl_VertexID >> 1) * 2. - 1., 0., 1.); }
EndVertex
Fragment inline
#version 330
out vec4 c;
void main() { c = vec4(1.); }
EndFragment
Program Corners
)";

TEST(Vertices, DrawEveryModeOfGl) {
    struct Row {
        const char* statement;
        int primitives;
    };
    for (const Row& row : {Row{"points 4", 4}, Row{"lines 4", 2}, Row{"line_strip 4", 3},
                           Row{"line_loop 4", 4}, Row{"triangles 6", 2}, Row{"triangle_strip 5", 3},
                           Row{"triangle_fan 5", 3}, Row{"polygon 5", 3}, Row{"quad_strip 6", 4}}) {
        const std::string scene = std::string(kCornerProgram) + "Pass target\nVertices " + row.statement +
                                  "\nEndPass\nExpect primitives " + std::to_string(row.primitives) +
                                  "\nExpect different target window\n";
        EXPECT_EQ(problemsOf(scene), "") << row.statement;
    }
    EXPECT_EQ(
        problemsOf(std::string(kCornerProgram) +
                   "Pass target\nVertices triangle_strip 4\nEndPass\nExpect count [1 1 1 1] 64 of target\n"),
        "");
}

TEST(Vertices, OfStripsWithAdjacencyReachTheGeometryStage) {
    const std::string scene = R"(Texture2D target 8 8 rgba8
Vertex inline
#version 330
void main() { gl_Position = vec4(0., 0., 0., 1.); }
EndVertex
Geometry inline
#version 330
layout(INPUT) in;
layout(points, max_vertices = 1) out;
void main() { gl_Position = gl_in[0].gl_Position; EmitVertex(); EndPrimitive(); }
EndGeometry
Fragment inline
#version 330
out vec4 c;
void main() { c = vec4(1.); }
EndFragment
Program Points
Pass target
    Vertices STATEMENT
EndPass
)";
    const auto with = [&](std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    };
    EXPECT_EQ(
        problemsOf(with(with(scene, "INPUT", "lines_adjacency"), "STATEMENT", "line_strip_adjacency 6") +
                   "Expect primitives 3\nExpect finite target\n"),
        "");
    EXPECT_EQ(problemsOf(with(with(scene, "INPUT", "triangles_adjacency"), "STATEMENT",
                              "triangle_strip_adjacency 8") +
                         "Expect primitives 2\nExpect finite target\n"),
              "");
    EXPECT_NE(problemsOf(with(with(scene, "INPUT", "triangles_adjacency"), "STATEMENT", "triangle_strip 8") +
                         "Expect finite target\n")
                  .find("draw-E02"),
              std::string::npos);
}

// ---- Stages.

TEST(Stages, OfAnEarlierProgramEndWithTheNextVertexStage) {
    RenderOptions options;
    options.view = ViewPolicy::glman;
    EXPECT_EQ(problemsOf(R"(WindowSize 8 8
Vertex inline
#version 400
void main() { gl_Position = aVertex; }
EndVertex
TessControl inline
#version 400
layout(vertices = 3) out;
void main() {
    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;
    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelInner[0] = 1.;
}
EndTessControl
TessEvaluation inline
#version 400
layout(triangles) in;
void main() { gl_Position = gl_in[0].gl_Position; }
EndTessEvaluation
Fragment inline
#version 400
out vec4 c;
void main() { c = vec4(1., 0., 0., 1.); }
EndFragment
Program Split
Vertex inline
#version 400
void main() { gl_Position = vec4(aTexCoord0.st * 2. - 1., 0., 1.); }
EndVertex
Program Plain
Let unused 1
QuadXY 0 1
Expect pixel 4 4 [1 0 0]
)",
                         {}, options),
              "");
}

// ---- Groups and files with parameters.

TEST(GroupParameters, MayBeTextures) {
    EXPECT_EQ(problemsOf(R"(WindowSize 8 8
Texture2D red 4 4 rgba8
Texture2DArray both 6 2 2 rgba8 levels 2
Texture2D out 8 8 rgba8
Texture2D outB 8 8 rgba8
Texture2D outC 8 8 rgba8
)" + showing("sampler2D", "vST") +
                         R"(Program Show
Pass red clear {1 0 0}
EndPass
Pass both.layer(1) clear {0 1 0}
EndPass
Group copy from red to out
    Set uT from
    Fill to with Show
    Draw inner from both.layer(1).level(1)
EndGroup
Group inner from red
    When (from.size.x == 3)
        Set uT from
    EndWhen
EndGroup
Draw copy
Draw copy from both.layer(1) to outB
Draw copy to outC
Fill window with Show uT red
Expect pixel 3 3 [1 0 0] of out
Expect pixel 3 3 [0 1 0] of outB
Expect pixel 3 3 [1 0 0] of outC
)"),
              "");
}

TEST(GroupParameters, MayBeVariablesByName) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nLet half .5\nGroup paint level 1\n"
                         "Pass window clear (vec3(level, 0, 0))\nEndPass\nEndGroup\n"
                         "Draw paint level half\nExpect pixel 3 3 [.5 0 0] within .01\n"),
              "");
    EXPECT_NE(problemsOf("Group paint level 1\nEndGroup\nDraw paint level lots\n"), "");
}

TEST(IncludedFiles, TakeValuesForTheirVariables) {
    const std::map<std::string, std::string> files{
        {"paint.glib",
         "Let level <0. 1. 1.>\nLet tint {0 1 0}\nPass window clear (level * tint)\nEndPass\n"}};
    EXPECT_EQ(problemsOf("WindowSize 8 8\nInclude paint.glib\nExpect pixel 3 3 [0 1 0]\n", files), "");
    EXPECT_EQ(
        problemsOf("WindowSize 8 8\nLet half (1 / 2)\nInclude paint.glib\n"
                   "Include paint.glib level half tint {1 0 1}\nExpect pixel 3 3 [.5 0 .5] within .01\n",
                   files),
        "");
    EXPECT_NE(problemsOf("Include paint.glib levle 1\n", files).find("did you mean 'level'"),
              std::string::npos);
}

TEST(MultMatrix, MultipliesTheCurrentMatrix) {
    const auto scene = [](const std::string& transforms) {
        return "WindowSize 32 32\nCamera eye LookAt 0 0 5 0 0 0 0 1 0 Perspective 50 .1 100\n" + transforms +
               "Box 1\n";
    };
    const Drawing matrix = draw(
        SceneFolder(scene("Translate 1 0 0\nMultMatrix (rotate(30, vec3(0, 0, 1)) * scale(1, 2, 1))\n")));
    const Drawing words = draw(SceneFolder(scene("Translate 1 0 0\nRotate 30 0 0 1\nScale 1 2 1\n")));
    const Drawing none = draw(SceneFolder(scene("Translate 1 0 0\n")));
    EXPECT_EQ(matrix.pixels, words.pixels);
    EXPECT_NE(matrix.pixels, none.pixels);
    EXPECT_NE(problemsOf("MultMatrix (vec3(1))\n"), "");
}

// ---- Values from the command line.

TEST(ChosenWords, SetAChoice) {
    const std::string scene =
        "WindowSize 8 8\nLet method <two_passes front_only unordered>\nLet level 1\n"
        "Pass window clear (method == unordered ? vec3(0, 1, 0) : vec3(1, 0, 0))\nEndPass\n"
        "Expect pixel 2 2 [0 1 0]\n";
    RenderOptions options;
    options.set = {"method=unordered"};
    EXPECT_EQ(problemsOf(scene, {}, options), "");
    options.set = {"method=2"};
    EXPECT_EQ(problemsOf(scene, {}, options), "");
    options.set = {"method=unorderd"};
    EXPECT_NE(problemsOf(scene, {}, options).find("did you mean 'unordered'"), std::string::npos);
    options.set = {"level=unordered"};
    EXPECT_NE(problemsOf(scene, {}, options).find("'unordered' is not a number"), std::string::npos);
    options.set = {"uKd=five"};
    EXPECT_NE(problemsOf("Sphere\n", {}, options).find("'five' is not a number"), std::string::npos);
}

// ---- Cameras of the window.

TEST(WindowTransforms, MoveTheRootOfDerivedCameras) {
    const auto scene = [](const std::string& camera) {
        return "WindowSize 32 32\nTexture2D other 32 32 rgba8\n"
               "Camera eye LookAt 0 0 5 0 0 0 0 1 0 Perspective 50 .1 100\n" +
               camera + showing("sampler2D", "vST") + R"(Program Show uT other
Vertex inline
#version 330
void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }
EndVertex
Fragment inline
#version 330
out vec4 c;
void main() { c = vec4(1.); }
EndFragment
Program White
Pass other from second
    Translate 1 0 0
    Box 1
EndPass
Pass window from eye
EndPass
Fill window with Show
)";
    };
    RenderOptions turned;
    turned.viewState.eye = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1};
    const auto pixels = [&](const std::string& camera, const RenderOptions& options) {
        return draw(SceneFolder(scene(camera)), options).pixels;
    };
    const std::string mirror = "Camera second Reflect eye 0 1 0 0\n";
    const std::string still = "Camera second LookAt 0 0 5 0 0 0 0 1 0 Perspective 50 .1 100\n";
    const std::string shifted = "Camera second Shift eye 1 0 0\n";
    EXPECT_NE(pixels(mirror, {}), pixels(mirror, turned));
    EXPECT_EQ(pixels(still, {}), pixels(still, turned));
    EXPECT_NE(pixels(shifted, {}), pixels(shifted, turned));
    // The window turns the camera before it is shifted: by half a turn the box comes from the other side.
    RenderOptions halfTurn;
    halfTurn.viewState.eye = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, -10, 1};
    const std::string behind =
        "Camera head LookAt 0 0 -5 0 0 0 0 1 0 Perspective 50 .1 100\nCamera second Shift head 1 0 0\n";
    EXPECT_EQ(pixels(shifted, halfTurn), pixels(behind, {}));
}

// ---- Stencil.

TEST(Stencil, NeedsAFormatThatHasOne) {
    const std::string scene = "Texture2D color 8 8 rgba8\nTexture2D depth 8 8 depth24\nPass color depth";
    for (const char* rest : {" clear stencil 1\nEndPass\n", "\nState mark 1\nEndPass\n",
                             "\nState stencil equal 1\nEndPass\n", "\nClear stencil\nEndPass\n"}) {
        const std::string problems = problemsOf(scene + rest);
        EXPECT_NE(problems.find("glib-E11"), std::string::npos) << rest << problems;
        EXPECT_NE(problems.find("depth24_stencil8"), std::string::npos) << rest << problems;
    }
}

// ---- Names.

TEST(Names, MayBeWordsOfARepetitionOrAChoice) {
    EXPECT_EQ(problemsOf(R"(WindowSize 8 8
Let pick <one two>
Texture2D one 8 8 rgba8
Texture2D two 8 8 rgba8
Camera left LookAt 0 0 5 0 0 0 0 1 0 Perspective 50 .1 100
Camera right Shift left 1 0 0
Group red
    Pass pick clear {1 0 0}
    EndPass
EndGroup
Group green
    Pass two clear {0 1 0}
    EndPass
EndGroup
Repeat [red green] as what
    Draw what
EndRepeat
Repeat [left right] as side
    Pass window from side keep
        Material gold
        Clear color
    EndPass
EndRepeat
Expect pixel 3 3 [1 0 0] of one
Expect pixel 3 3 [0 1 0] of two
)"),
              "");
    EXPECT_NE(problemsOf("Repeat [left right] as side\nPass window from side\nEndPass\nEndRepeat\n")
                  .find("no camera 'left'"),
              std::string::npos);
}

TEST(Names, MayBeThoseOfKeys) {
    EXPECT_EQ(problemsOf("WindowSize 8 8\nTexture2D color 8 8 rgba8\nTexture2D depth 8 8 depth24\n"
                         "Buffer count uint [3]\n"
                         "Pass color depth clear {1 0 0} depth .5\nEndPass\n"
                         "Expect pixel 1 1 [.5] of depth within .001\nExpect buffer count [3]\n"),
              "");
    EXPECT_NE(problemsOf("Let rounds 3\nRepeat rounds\nEndRepeat\n").find("write (rounds)"),
              std::string::npos);
}

// ---- Checks.

TEST(Conditions, NeedTheBuffersThatTheyReadAndNoOthers) {
    const auto scene = [](const std::string& condition) {
        return R"(Compute inline
#version 430
layout(local_size_x = 1) in;
buffer Sum { float sum[]; };
void main() { sum[0] = 3.; }
EndCompute
Program Add
Buffer Sum float 1
Buffer Su float [3]
Dispatch Add 1 1 1
Expect ()" + condition +
               ")\n";
    };
    EXPECT_EQ(problemsOf(scene("Sum[0] == 3")), "");
    RenderOptions checked;
    checked.checks = true;
    EXPECT_EQ(draw(SceneFolder(scene("Sum[0] == 3")), checked).count("dispatches"), 1U);
    EXPECT_EQ(draw(SceneFolder(scene("Su[0] == 3")), checked).count("dispatches"), 0U);
}

// ---- Indices outside of buffers.

TEST(OutsideOfABuffer, NothingIsWritten) {
    EXPECT_EQ(problemsOf(R"(Compute inline
#version 430
layout(local_size_x = 1) in;
buffer Small { float small[]; };
buffer Result { float result[]; };
void main() {
    for (int i = 4; i < 4000; i += 7) small[i] = 5.;
    result[0] = small[100000] == 5. ? 1. : 2.;
}
EndCompute
Program Outside
Buffer Small float [1 2 3 4]
Buffer Other float [7 8 9]
Buffer Result float 1
Dispatch Outside 1 1 1
Expect buffer Small [1 2 3 4]
Expect buffer Other [7 8 9]
Expect buffer Result [2]
)"),
              "");
}

}  // namespace
}  // namespace glibra::test
