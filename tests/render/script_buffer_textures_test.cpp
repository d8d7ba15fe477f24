// Buffers that shaders read as textures: samplerBuffer and imageBuffer (language, 12.7).

#include <gtest/gtest.h>

#include <string>

#include "modern_text.h"
#include "script_problems.h"

namespace glibra::test {
namespace {

/// A scene of 8 x 1 pixels, each of which shows texel x of `data`, read by a sampler of this type.
std::string showingTexels(const std::string& sampler, const std::string& value, const std::string& buffer,
                          const std::string& tag = "uData data") {
    return "WindowSize 8 1\n" + buffer + "Fragment inline\n#version 410 core\nuniform " + sampler +
           " uData;\nout vec4 c;\nvoid main() { int i = int(gl_FragCoord.x); c = vec4(" + value +
           "); }\nEndFragment\nProgram P  " + tag + "\nFill window with P\n";
}
const std::string kFirstComponent = "texelFetch(uData, i).r, 0, 0, 1";

TEST(ScriptBufferTextures, ReadTheElementsOfEveryType) {
    const auto problems = [](const std::string& sampler, const std::string& value,
                             const std::string& buffer) {
        return problemsOf(showingTexels(sampler, value, "Buffer data " + buffer + "\n") +
                          "Expect pixel 0 0 [0 .2 .4 .6]\nExpect pixel 3 0 [.2 .4 .6 .8]\n");
    };
    EXPECT_EQ(
        problems("samplerBuffer",
                 "texelFetch(uData, 4*i).r, texelFetch(uData, 4*i + 1).r, texelFetch(uData, 4*i + 2).r, "
                 "texelFetch(uData, 4*i + 3).r",
                 "float [0 .2 .4 .6  0 0 0 0  0 0 0 0  .2 .4 .6 .8]"),
        "");
    EXPECT_EQ(problems("samplerBuffer", "texelFetch(uData, 2*i).rg, texelFetch(uData, 2*i + 1).rg",
                       "vec2 [0 .2 .4 .6  0 0 0 0  0 0 0 0  .2 .4 .6 .8]"),
              "");
    EXPECT_EQ(problems("samplerBuffer", "texelFetch(uData, i).rgb, i == 0 ? .6 : .8",
                       "vec3 [0 .2 .4  0 0 0  0 0 0  .2 .4 .6]"),
              "");
    EXPECT_EQ(
        problems("samplerBuffer", "texelFetch(uData, i)", "vec4 [0 .2 .4 .6  0 0 0 0  0 0 0 0  .2 .4 .6 .8]"),
        "");
    EXPECT_EQ(problems("samplerBuffer", "texelFetch(uData, 2*i).rg, texelFetch(uData, 2*i + 1).rg",
                       "mat2 [0 .2 .4 .6  0 0 0 0  0 0 0 0  .2 .4 .6 .8]"),
              "");
    EXPECT_EQ(problems("samplerBuffer", "texelFetch(uData, 3*i + 1).rgb, i == 0 ? .6 : .8",
                       "mat3 4 (mat3(vec3(9), i == 0 ? vec3(0, .2, .4) : vec3(.2, .4, .6), vec3(9)))"),
              "");
    EXPECT_EQ(problems("samplerBuffer", "texelFetch(uData, 4*i + 2)",
                       "mat4 4 (mat4(vec4(9), vec4(9), i == 0 ? vec4(0, .2, .4, .6) : vec4(.2, .4, .6, .8), "
                       "vec4(9)))"),
              "");
    EXPECT_EQ(problems("isamplerBuffer", "-.1 * vec4(texelFetch(uData, i))",
                       "ivec4 [0 -2 -4 -6  0 0 0 0  0 0 0 0  -2 -4 -6 -8]"),
              "");
    EXPECT_EQ(problems("usamplerBuffer", "vec4(texelFetch(uData, i)) / 4e9",
                       "uvec4 [0 800000000 1600000000 2400000000  0 0 0 0  0 0 0 0 "
                       "800000000 1600000000 2400000000 3200000000]"),
              "");
}

TEST(ScriptBufferTextures, AreFoundByNameAndHaveTheSizeOfTheBuffer) {
    EXPECT_EQ(
        problemsOf(showingTexels("samplerBuffer", kFirstComponent, "Buffer uData float 8 (i/10)\n", "") +
                   "Expect pixel 5 0 [.5] within .01\n"),
        "");
    EXPECT_EQ(problemsOf(showingTexels("samplerBuffer", "vec4(float(textureSize(uData)) / 10)",
                                       "Buffer data float 8 (i/10)\n") +
                         "Expect pixel 5 0 [.8]\n"),
              "");
    EXPECT_EQ(problemsOf("Buffer low float 8\nBuffer high float 8 (1)\nLet which <low high>\n" +
                         showingTexels("samplerBuffer", kFirstComponent, "", "uData which") +
                         "Expect pixel 5 0 [0]\n"),
              "");
}

TEST(ScriptBufferTextures, SkippingChangesNoByte) {
    const SceneFolder folder(
        showingTexels("samplerBuffer", kFirstComponent, "Buffer data float 8 (i/8)\nBuffer no float 8\n"));
    const BothWays both = drawBothWays(folder);
    EXPECT_EQ(both.skipping.count("buffers"), 1U);
}

const std::string kCountingUp = R"(Compute inline
#version 430 core
layout(local_size_x = 8) in;
layout(std430) buffer data { float numbers[]; };
void main() { numbers[gl_LocalInvocationIndex] += .1; }
EndCompute
Program Count
)";

TEST(ScriptBufferTextures, ShowWhatShadersHaveWritten) {
    if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    const std::string begin = "WindowSize 8 1\nBuffer data float 8 (i/10)\n" + kCountingUp;
    const std::string end = showingTexels("samplerBuffer", kFirstComponent, "");
    EXPECT_EQ(problemsOf(begin + "Dispatch Count 1\n" + end + "Expect pixel 4 0 [.5] within .01\n"), "");
    EXPECT_EQ(
        problemsOf(begin + "Once\nDispatch Count 1\nEndOnce\n" + end + "Expect pixel 4 0 [.5] within .01\n"),
        "");
    EXPECT_EQ(problemsOf(begin + "Step 10\nDispatch Count 1\nEndStep\n" + end +
                         "Expect pixel 4 0 [.4] within .01\nExpect pixel 4 0 [.7] within .01 at .3\n"),
              "");
}

TEST(ScriptBufferTextures, ImagesWriteThem) {
    if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    EXPECT_EQ(
        problemsOf(R"(WindowSize 8 1
Buffer data float 8 (i/10)
Buffer more float 8
Compute inline
#version 430 core
layout(local_size_x = 8) in;
uniform samplerBuffer uFrom;
layout(r32f) uniform writeonly imageBuffer uTo;
void main() {
    int i = int(gl_LocalInvocationIndex);
    imageStore(uTo, i, texelFetch(uFrom, 7 - i));
}
EndCompute
Program Turn  uFrom data uTo more
Dispatch Turn 1
)" + showingTexels("samplerBuffer", kFirstComponent, "", "uData more") +
                   "Expect pixel 7 0 [0]\nExpect pixel 2 0 [.5]\nExpect buffer more [.7 .6] within 1e-6\n"),
        "");
}

TEST(ScriptBufferTextures, WithHistoryHaveBothCopies) {
    if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    const std::string scene = "WindowSize 8 1\nBuffer data float 8 (i/10) history\n" + kCountingUp +
                              "Step 10\nDispatch Count 1\nEndStep\n";
    EXPECT_EQ(problemsOf(scene + showingTexels("samplerBuffer", kFirstComponent, "", "uData data.prev") +
                         "Expect pixel 4 0 [.5] within .01 at .2\nExpect pixel 4 0 [.6] within .01 at .3\n"),
              "");
}

TEST(ScriptBufferTextures, MustFitTheElements) {
    const auto expect = [](const std::string& scene, const std::string& message) {
        const std::string refused = refusalOf(scene);
        EXPECT_NE(refused.find(message), std::string::npos) << refused;
    };
    const auto withType = [](const std::string& type) {
        return showingTexels("samplerBuffer", kFirstComponent, "Buffer data " + type + "\n");
    };
    expect(
        withType("int 8"),
        "9:12: error: samplerBuffer 'uData' (scene.glib:5) cannot read buffer 'data' (line 2), which holds "
        "int; write isamplerBuffer [draw-E09]");
    expect(withType("uvec2 8"), "which holds uvec2; write usamplerBuffer [draw-E09]");
    expect(
        withType("double 8"),
        "which holds double; only float, int, uint, vectors and matrices of them can be read as a texture");
    expect(withType("8"), "which has no type; write one of float, int, uint, vectors and matrices");
    expect(showingTexels("isamplerBuffer", "texelFetch(uData, i)", "Buffer data vec4 8\n"),
           "which holds vec4; write samplerBuffer");
    expect(showingTexels("sampler2D", "texelFetch(uData, ivec2(i, 0), 0)", "Buffer data vec4 8\n"),
           "sampler2D 'uData' (scene.glib:5) cannot read buffer 'data' (line 2), which holds vec4; write "
           "samplerBuffer [draw-E09]");
    expect(
        showingTexels("samplerBuffer", kFirstComponent, "Texture2D data 8 8 rgba8\n"),
        "samplerBuffer 'uData' (scene.glib:5) cannot read 'data' (line 2), which is a 2D texture of rgba8; "
        "write sampler2D [draw-E09]");
}

TEST(ScriptBufferTextures, ABlockOfAnotherLayoutIsRefused) {
    const std::string refused = refusalOf(R"(WindowSize 8 1
Buffer data float 8
Fragment inline
#version 410 core
uniform samplerBuffer uData;
layout(std140) uniform data { float numbers[8]; };
out vec4 c;
void main() { c = texelFetch(uData, 1) + numbers[2]; }
EndFragment
Program P  uData data
Fill window with P
)");
    EXPECT_NE(refused.find("scene.glib:2:1: error: uniform block 'data' ("), std::string::npos) << refused;
    EXPECT_NE(refused.find("scene.glib:11) lay out buffer 'data' differently"), std::string::npos) << refused;
}

}  // namespace
}  // namespace glibra::test
