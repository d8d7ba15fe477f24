// Mistakes of modern scenes that were silent, late or blamed on the wrong thing: each is one message.

#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

/// The messages of drawing a scene and answering its checks as "line id", without notes.
std::string idsOf(const std::string& scene) {
    std::istringstream lines(problemsOf(scene));
    std::string found;
    const std::regex message("scene.glib:([0-9]+):[0-9]+: (?:error|warning): .*\\[(.*)\\]");
    for (std::string line; std::getline(lines, line);)
        if (std::smatch parts; std::regex_search(line, parts, message))
            found += (found.empty() ? "" : ", ") + parts[1].str() + " " + parts[2].str();
        else if (line.find(": note: ") == std::string::npos && !line.empty())
            found += "?" + line;
    return found;
}

/// A program `Show` that reads the texture `glow`, in 8 lines, and `Red`, in 6.
const std::string kShow = R"(WindowSize 8 8
Texture2D glow 8 8 rgba8
Fragment inline
#version 330
uniform sampler2D uGlow;
in vec2 vST;
out vec4 fColor;
void main() { fColor = texture(uGlow, vST) + vec4(vST, 0., 1.); }
EndFragment
Program Show  uGlow glow
Fragment inline
#version 330
out vec4 fColor;
void main() { fColor = vec4(1., 0., 0., 1.); }
EndFragment
Program Red
)";

TEST(UnwrittenTextures, AreReportedWhateverAWhenDecides) {
    const std::string kUnwritten = " draw-W11";
    EXPECT_EQ(idsOf(kShow + "Let big <false>\nWhen (big)\n    Scale 2\nEndWhen\nFill window with Show\n"),
              "21" + kUnwritten);
    EXPECT_EQ(idsOf(kShow + "When (time < 1)\n    Scale 2\nEndWhen\nFill window with Show\n"),
              "20" + kUnwritten);
    EXPECT_EQ(idsOf(kShow + "Let big <true>\nWhen (big)\n    Fill window with Show\nEndWhen\n"),
              "19" + kUnwritten);
    EXPECT_EQ(idsOf(kShow + "Let on <false>\nWhen (on)\n    Fill window with Show\nEndWhen\n"
                            "Fill window with Show\n"),
              "21" + kUnwritten)
        << "a reader that does not run writes nothing";
    EXPECT_EQ(idsOf(kShow + "Group draws\n    Fill glow with Red\nEndGroup\nFill window with Show\n"),
              "20" + kUnwritten)
        << "nothing draws the group";
}

TEST(UnwrittenTextures, AreUndecidedWhereAWriterDoesNotRun) {
    const auto with = [](const std::string& writer) {
        return idsOf(kShow + writer + "Fill window with Show\n");
    };
    EXPECT_EQ(with("Let on <false>\nWhen (on)\n    Fill glow with Red\nEndWhen\n"), "");
    EXPECT_EQ(with("Let on <true>\nWhen (on)\n    Scale 2\nElse\n    Fill glow with Red\nEndWhen\n"), "");
    EXPECT_EQ(with("Let on <false>\nWhen (on)\n    Pass glow clear {1 0 0}\n    EndPass\nEndWhen\n"), "");
    EXPECT_EQ(
        with("Let on <false>\nWhen (on)\n    When (time > 1)\n        Clear glow\n    EndWhen\nEndWhen\n"),
        "");
    EXPECT_EQ(with("Group draws\n    Fill glow with Red\nEndGroup\nLet on <false>\nWhen (on)\n    Draw "
                   "draws\nEndWhen\n"),
              "");
    EXPECT_EQ(with("Texture2D other 8 8 rgba8\nGroup draws to other\n    Fill to with Red\nEndGroup\nLet on "
                   "<false>\nWhen (on)\n    Draw draws to glow\nEndWhen\n"),
              "");
    EXPECT_EQ(with("Let n <0 0 4>\nRepeat (n)\n    Fill glow with Red\nEndRepeat\n"), "");
    EXPECT_EQ(with("Texture2D other 8 8 rgba8\nLet target <other glow>\nFill target with Red\n"), "");
}

TEST(ImageWriters, ThatDoNotRunAreUndecided) {
    const std::string compute = R"(Compute inline
#version 430
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba8) writeonly uniform image2D uOut;
void main() { imageStore(uOut, ivec2(gl_GlobalInvocationID.xy), vec4(1.)); }
EndCompute
Program Make  uOut glow
Let on <false>
When (on)
    Dispatch Make over glow
EndWhen
Fill window with Show
)";
    EXPECT_EQ(idsOf(kShow + compute), "");
}

TEST(WordsOfChoices, MayBeNamesOfOtherThings) {
    const std::string begin =
        "WindowSize 8 8\nTexture2D stone 8 8 rgba8\nBuffer wood float 4\nLet cover <stone "
        "wood min list>\nLet list[3] (i)\nPass window clear {0 0 0}\nEndPass\n";
    for (const char* each : {"(cover == stone)", "(stone == cover)", "(cover != wood)", "(cover != min)",
                             "(!(list == cover))", "((cover == stone ? 1 : .5) == 1)"})
        EXPECT_EQ(problemsOf(begin + "Expect " + each + "\n"), "") << each;
    EXPECT_NE(problemsOf(begin + "Expect (stone + 1 == 2)\n").find("'stone' is a texture, not a value"),
              std::string::npos);
    EXPECT_NE(problemsOf(begin + "Expect (min == 2)\n").find("'min' is a function"), std::string::npos);
    EXPECT_NE(problemsOf(begin + "Expect (list == 2)\n").find("'list' is an array"), std::string::npos);
}

const std::string kStages = R"(WindowSize 16 16
Camera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 40 .1 100
Vertex inline
#version 330
void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }
EndVertex
Fragment inline
#version 330
out vec4 fColor;
void main() { fColor = vec4(0., 1., 0., 1.); }
EndFragment
)";

TEST(Stages, ThatNoProgramTakesAreReported) {
    EXPECT_EQ(idsOf(kStages + "Box\n"), "3 draw-W16");
    EXPECT_EQ(idsOf(kStages + "Program Green\nBox\n"), "");
    const std::string again =
        "Fragment inline\n#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n"
        "EndFragment\n";
    EXPECT_EQ(idsOf(kStages + again + "Program White\nBox\n"), "7 draw-W16");
    EXPECT_EQ(idsOf(kStages + "Program Green\n" + again + "Box\n"), "13 draw-W16");
    EXPECT_EQ(idsOf(kStages +
                    "Program Green\nVertex inline\n#version 330\nvoid main() { gl_Position = "
                    "aVertex; }\nEndVertex\n" +
                    again + "Program Other\nBox\n"),
              "");
}

TEST(EndWords, ThatAreMissingAreOneMessage) {
    const auto without = [](const std::string& instead) {
        std::string scene = kStages + "Program Green\nBox\n";
        const std::size_t at = scene.find("EndVertex\n");
        return idsOf(scene.replace(at, 10, instead));
    };
    EXPECT_EQ(without("EndVertex\n"), "");
    for (const char* each : {"", "EndFragment\n", "EndPass\n", "EndVertx\n", "endgroup\n"})
        EXPECT_EQ(without(each), "3 glib-E22") << each;
    EXPECT_EQ(without("// EndFragment\nEndVertex\n"), "");
    EXPECT_EQ(without("/*\nEndFragment\nProgram Lit\n*/\nEndVertex\n"), "") << "a comment of the shader";
    std::string scene = kStages + "Program Green  uA 1\nBox\n";
    const std::size_t at = scene.find("EndFragment\n");
    EXPECT_EQ(idsOf(scene.erase(at, 12)), "7 glib-E22");
}

TEST(Backslashes, ThatAreMissingAreOneMessage) {
    const std::string begin = kShow + "Fill glow with Red\n";
    const auto reported = [&](const std::string& lines) { return idsOf(begin + lines); };
    EXPECT_EQ(reported("Camera eye LookAt 0 0 5  0 0 0\n    0 1 0  Perspective 40 .1 100\nFill window with "
                       "Show\n"),
              "18 glib-E17");
    EXPECT_EQ(reported("Camera eye LookAt 0 0 5  0 0 0  0 1 0\n    Perspective 40 .1 100\nFill window with "
                       "Show\n"),
              "18 glib-E17");
    EXPECT_EQ(reported("Pass window clear depth\n    1\nEndPass\nFill window with Show\n"), "18 glib-E17");
    EXPECT_EQ(reported("Texture2D other 4 4 rgba8\n    linear clamp\nFill window with Show\n"),
              "19 glib-E01");
    EXPECT_EQ(reported("Fill window with Show\n    uGlow glow\n    uOther 4\n"), "19 glib-E01");
    EXPECT_EQ(reported("Pass window\n    clear {1 0 0}\nEndPass\nFill window with Show\n"), "19 glib-E19");
    EXPECT_EQ(reported("LookAt 0 0 5  0 0 0\n    0 1 0\nFill window with Show\n"), "18 glib-E04");
}

TEST(Expressions, WithoutParenthesesAreShownWhole) {
    const auto advice = [](const std::string& lines) {
        const std::string found = problemsOf("WindowSize 8 8\nLet k <0 1 2>\n" + lines + "Sphere\n");
        const std::size_t at = found.find("write ");
        return at == std::string::npos ? found : found.substr(at, found.find(" for its value") - at);
    };
    EXPECT_EQ(advice("Rotate 360*rand(k, 3) 0 1 0\n"), "write (360*rand(k, 3))");
    EXPECT_EQ(advice("Rotate 2*(k + 1) 0 1 0\n"), "write (2*(k + 1))");
    EXPECT_EQ(advice("Let a 360*rand(k, 3)\n"), "write (360*rand(k, 3))");
    EXPECT_EQ(advice("Camera eye LookAt 0 0 2*max(k, 3)  0 0 0  0 1 0  Perspective 40 .1 100\n"),
              "write (2*max(k, 3))");
    EXPECT_EQ(advice("Repeat max(k, 3)\nEndRepeat\n"), "write (max(k, 3))");
}

TEST(WordsOfTags, ThatNameNothingAreNotTheTagsFault) {
    const std::string sum = R"(Buffer heights float [3 1 2]
Compute inline
#version 430
layout(local_size_x = 3) in;
layout(std430) buffer Data { float data[]; } all;
void main() { all.data[gl_GlobalInvocationID.x] += 1.; }
EndCompute
)";
    const auto found = [&](const std::string& tag) {
        return problemsOf(sum + "Program Raise  " + tag +
                          "\nDispatch Raise 1\nExpect buffer heights [4 2 3]\n");
    };
    for (const char* each : {"Data", "all", "data"}) {
        const std::string said = found(each + std::string(" heigths"));
        EXPECT_NE(said.find("'heigths' is no variable, texture or buffer; did you mean 'heights'?"),
                  std::string::npos)
            << said;
        EXPECT_EQ(said.find("uniform"), std::string::npos) << said;
        EXPECT_EQ(said.find("memory-E02"), std::string::npos) << said;
    }
    EXPECT_EQ(found("Data heights"), "");
}

TEST(Patches, AreAsLargeAsTheControlStageReads) {
    const auto scene = [](const std::string& size, const std::string& control) {
        return "WindowSize 16 16\nCamera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 40 .1 100\nVertex "
               "inline\n#version 410\nvoid main() { gl_Position = vec4(gl_VertexID % 2, gl_VertexID / 2, 0., "
               "1.); }\nEndVertex\nTessControl inline\n#version 410\nlayout(vertices = 4) out;\nvoid main() "
               "{\n    gl_out[gl_InvocationID].gl_Position = " +
               control +
               ";\n    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = "
               "gl_TessLevelOuter[3] = 1.;\n    gl_TessLevelInner[0] = gl_TessLevelInner[1] = "
               "1.;\n}\nEndTessControl\nTessEvaluation inline\n#version 410\nlayout(quads) in;\nvoid main() "
               "{ "
               "gl_Position = gl_in[int(3. * gl_TessCoord.x)].gl_Position; }\nEndTessEvaluation\nFragment "
               "inline\n#version 410\nout vec4 c;\nvoid main() { c = vec4(gl_FragCoord.xy, 0., 1.); "
               "}\nEndFragment\nProgram Quads\n" +
               size + "Vertices patches 4\n";
    };
    EXPECT_EQ(idsOf(scene("", "gl_in[gl_InvocationID].gl_Position")), "27 draw-W17");
    EXPECT_EQ(idsOf(scene("", "gl_in[3].gl_Position")), "27 draw-W17");
    EXPECT_EQ(idsOf(scene("", "gl_in[2].gl_Position")), "");
    EXPECT_EQ(idsOf(scene("NumPatchVertices 4\n", "gl_in[gl_InvocationID].gl_Position")), "");
}

std::string dispatching(const std::string& declarations, const std::string& body,
                        const std::string& statements, const std::string& local = "local_size_x = 4") {
    return declarations + "Compute inline\n#version 430\nlayout(" + local +
           ") in;\nlayout(std430) buffer Data { float data[]; };\nlayout(r32f) writeonly uniform image2D "
           "uOut;\nvoid main() {\n" +
           body + "\n}\nEndCompute\nProgram Make  Data values  uOut map\n" + statements +
           "Expect finite values\nExpect finite map\n";
}

TEST(Elements, ThatABufferLacksAreReported) {
    const auto found = [](const std::string& body, const std::string& dispatch) {
        return idsOf(dispatching("Buffer values float 6\nTexture2D map 8 8 r32f\n",
                                 body + "\nimageStore(uOut, ivec2(0), vec4(1.));", dispatch));
    };
    EXPECT_EQ(found("data[gl_GlobalInvocationID.x] = 1.;", "Dispatch Make 2\n"), "14 memory-W05");
    EXPECT_EQ(found("uint i = gl_GlobalInvocationID.x; data[i] = 1.;", "Dispatch Make 2\n"), "14 memory-W05");
    EXPECT_EQ(found("data[7] = 1.;", "Dispatch Make 1\n"), "14 memory-W05");
    EXPECT_EQ(found("data[gl_GlobalInvocationID.x] = 1.;", "Dispatch Make 1\n"), "");
    EXPECT_EQ(found("data[gl_GlobalInvocationID.x] = 1.;", "Dispatch Make over values\n"), "");
    EXPECT_EQ(
        found("uint i = gl_GlobalInvocationID.x; if (i < data.length()) data[i] = 1.;", "Dispatch Make 2\n"),
        "");
}

TEST(Axes, ThatADispatchMissesAreReported) {
    const auto found = [](const std::string& body, const std::string& dispatch) {
        return idsOf(dispatching("Buffer values float 64\nTexture2D map 64 64 r32f\n",
                                 body + "\ndata[0] = 1.;", dispatch, "local_size_x = 8, local_size_y = 8"));
    };
    const std::string store = "imageStore(uOut, ivec2(gl_GlobalInvocationID.xy), vec4(1.));";
    EXPECT_EQ(found(store, "Dispatch Make 8\n"), "14 memory-W06");
    EXPECT_EQ(found(store, "Dispatch Make 1 8\n"), "14 memory-W06");
    EXPECT_EQ(found(store, "Dispatch Make 8 8\n"), "");
    EXPECT_EQ(found(store, "Dispatch Make over map\n"), "");
    EXPECT_EQ(found(store, "Dispatch Make over 64\n"), "14 memory-W06");
    EXPECT_EQ(found("imageStore(uOut, ivec2(gl_GlobalInvocationID.x, 3), vec4(1.));", "Dispatch Make 8\n"),
              "");
}

TEST(BufferTypes, AreThoseOfAllNumbersOfAFixedBlock) {
    const auto found = [](const std::string& block) {
        return idsOf(
            "Buffer values float 3\nCompute inline\n#version 430\nlayout(local_size_x = 1) "
            "in;\nlayout(std430) buffer Data { " +
            block +
            " };\nvoid main() { a += 1.; }\nEndCompute\nProgram Make  Data values\nDispatch Make "
            "1\nExpect finite values\n");
    };
    EXPECT_EQ(found("float a; uint b; float c;"), "1 memory-W04");
    EXPECT_EQ(found("float a; float b; float c;"), "");
    EXPECT_EQ(found("float a; int b[2];"), "1 memory-W04");
}

TEST(MaxVertices, AreReportedIfAStripHasMore) {
    const auto found = [](const std::string& most) {
        return idsOf(
            "WindowSize 16 16\nCamera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 40 .1 100\nVertex "
            "inline\n#version 330\nvoid main() { gl_Position = vec4(0., 0., 0., 1.); "
            "}\nEndVertex\nGeometry inline\n#version 330\nlayout(points) in;\nlayout(triangle_strip, "
            "max_vertices = " +
            most +
            ") out;\nvoid main() {\n    for (int i = 0; i < 4; ++i) {\n        gl_Position = vec4(i % "
            "2, i / 2, 0., 1.);\n        EmitVertex();\n    }\n}\nEndGeometry\nFragment inline\n"
            "#version 330\nout vec4 c;\nvoid main() { c = vec4(gl_FragCoord.xy, 0., 1.); "
            "}\nEndFragment\nProgram Squares\nVertices points 1\n");
    };
    EXPECT_EQ(found("3"), "10 glsl-W27");
    EXPECT_EQ(found("4"), "");
}

TEST(Subscripts, OfTagsAreReadInClassicScenes) {
    const std::map<std::string, std::string> files{
        {"a.vert", "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n"},
        {"a.frag",
         "#version 330 compatibility\nstruct Lamp { vec3 tint; float power; };\nuniform Lamp uLamps[2];\n"
         "void main() { gl_FragColor = vec4(uLamps[0].tint * uLamps[0].power + uLamps[1].tint * "
         "uLamps[1].power, 1.) * "
         "gl_FragCoord.x; }\n"}};
    EXPECT_EQ(problemsOf("WindowSize 16 16\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\nProgram Lamps "
                         "uLamps[0].tint [1 .5 .25] uLamps[0].power .5 uLamps[1].tint [0 0 .5] "
                         "uLamps[1].power 2\nQuadXY 0 1\n",
                         files),
              "");
}

TEST(Matrices, AreNoVectors) {
    EXPECT_EQ(idsOf("WindowSize 8 8\nCamera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 40 .1 100\nFragment "
                    "inline\n#version 330\nuniform vec3 uTint;\nout vec4 c;\nvoid main() { c = vec4(uTint, "
                    "1.); }\nEndFragment\nProgram P  uTint (eye.view)\nFill window with P\n"),
              "9 glib-E30");
}

TEST(Loops, OverTheSizeOfAnImageAreCounted) {
    const auto found = [](int side) {
        const std::string size = std::to_string(side);
        return problemsOf("Buffer total float 1\nTexture2D ones " + size + " " + size + R"( r32f
Compute inline
#version 430
layout(local_size_x = 1) in;
layout(std430) buffer Total { float total; };
layout(r32f) readonly uniform image2D uOnes;
void main() {
    ivec2 size = imageSize(uOnes);
    float sum = 0.;
    for (int y = 0; y < size.y; y++)
        for (int x = 0; x < size.x; x++) sum += imageLoad(uOnes, ivec2(x, y)).r;
    total = sum;
}
EndCompute
Program Sum  uOnes ones
Pass ones clear {1}
EndPass
Dispatch Sum 1
Expect buffer total [)" + std::to_string(side * side) +
                          "]\n");
    };
    EXPECT_EQ(found(100), "");
    const std::string of300 = found(300);
    EXPECT_TRUE(of300.empty() || of300.find("draw-W08") != std::string::npos) << of300;
}

/// A plane to the horizon, with texture coordinates that reach far.
std::string plane(const std::string& options, const std::string& check) {
    return "WindowSize 40 20\nCamera eye LookAt 0 1 0  0 1 -10  0 1 0  Perspective 60 .1 10000\nTexture2D "
           "checks 256 256 rgba8 " +
           options + R"( repeat
Fragment inline
#version 330
in vec2 vST;
out vec4 fColor;
void main() { fColor = vec4(vec3(mod(floor(vST.x * 16.) + floor(vST.y * 16.), 2.)), 1.); }
EndFragment
Program Checks
Fill checks with Checks
Vertex inline
#version 330
out vec2 vUV;
void main() { vUV = aVertex.xz; gl_Position = uModelViewProjectionMatrix * aVertex; }
EndVertex
Fragment inline
#version 330
in vec2 vUV;
uniform sampler2D uMap;
out vec4 fColor;
void main() { fColor = texture(uMap, vUV); }
EndFragment
Program Plane  uMap checks
QuadXZ 0 5000
)" + check;
}

TEST(Anisotropy, OfAPlaneToTheHorizonEnds) {
    // Each of them took minutes on llvmpipe. The mean of the checks is a half.
    for (const char* each :
         {"linear aniso 8", "mipmap aniso 8 levels 3 generate", "mipmap aniso 16 generate"})
        EXPECT_EQ(problemsOf(plane(each, "Expect mean 0 0 40 9 [.5 .5 .5] within .1\n")), "") << each;
}

}  // namespace
}  // namespace glibra::test
