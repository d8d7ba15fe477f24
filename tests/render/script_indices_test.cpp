// Vertices ... indices: meshes whose vertices are numbered by a buffer (language, 12.6).

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "modern_text.h"
#include "script_problems.h"

namespace glibra::test {
namespace {

const std::string kTintedMesh = R"(WindowSize 64 64
Vertex inline
#version 410 core
in vec2 aPlace;
in vec2 aShift;
in vec3 aTint;
flat out vec3 vTint;
void main() { gl_Position = vec4(aPlace + aShift, 0, 1); vTint = aTint; }
EndVertex
Fragment inline
#version 410 core
flat in vec3 vTint;
out vec4 c;
void main() { c = vec4(vTint, 1); }
EndFragment
Program P
Use P
Attribute aShift 0 0
)";

// A fan of six triangles around the middle, whose corners have colours of their own.
const std::string kIndexedFan =
    "Buffer hub vec2 7 (i == 0 ? vec2(0) : .8*vec2(cos(i*pi/3), sin(i*pi/3)))\n"
    "Buffer tints vec3 7 (vec3(i/6, 1 - i/6, mod(i, 2)))\n"
    "Buffer faces uint [0 1 2  0 2 3  0 3 4  0 4 5  0 5 6  0 6 1]\n"
    "Attribute aPlace hub\nAttribute aTint tints\n";

// The same triangles, each with three vertices of its own.
const std::string kUnindexedFan =
    "Buffer all vec2 18 (mod(i, 3) == 0 ? vec2(0) : "
    ".8*vec2(cos((floor(i/3) + mod(i, 3))*pi/3), sin((floor(i/3) + mod(i, 3))*pi/3)))\n"
    "Let k[18] (mod(i, 3) == 0 ? 0 : mod(floor(i/3) + mod(i, 3) - 1, 6) + 1)\n"
    "Buffer tints vec3 18 (vec3(k[i]/6, 1 - k[i]/6, mod(k[i], 2)))\n"
    "Attribute aPlace all\nAttribute aTint tints\n";

std::vector<std::byte> bytesOf(const std::string& scene, bool skips = true) {
    RenderOptions options;
    options.skip = skips;
    return TextScene(kTintedMesh + scene, {}, options).draw().data;
}

TEST(ScriptIndices, DrawTheSameBytesAsVerticesOfTheirOwn) {
    const std::vector<std::byte> singly = bytesOf(kUnindexedFan + "Vertices triangles 18\n");
    ASSERT_GT(std::ranges::count(singly, std::byte{255}), 300);
    EXPECT_EQ(bytesOf(kIndexedFan + "Vertices triangles indices faces\n"), singly);
    EXPECT_EQ(bytesOf(kIndexedFan + "Vertices triangles 18 indices faces\n"), singly);
    EXPECT_EQ(bytesOf(kIndexedFan + "Vertices triangles indices faces\n", false), singly);
    EXPECT_EQ(bytesOf(kIndexedFan + "Buffer n uint [18]\nVertices triangles from n indices faces\n"), singly);
    EXPECT_EQ(
        bytesOf(kIndexedFan + "Buffer n uint [1]\nInstances from n\nVertices triangles indices faces\n"),
        singly);
    EXPECT_EQ(bytesOf(kIndexedFan + "Buffer same int [0 1 2  0 2 3  0 3 4  0 4 5  0 5 6  0 6 1]\n"
                                    "Vertices triangles indices same\n"),
              singly);
    EXPECT_NE(bytesOf(kIndexedFan + "Vertices triangles 15 indices faces\n"), singly);
}

TEST(ScriptIndices, AFileHoldsThemToo) {
    std::string faces;
    for (const int each : {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 6, 0, 6, 1})
        faces += {static_cast<char>(each), 0, 0, 0};
    const std::string scene =
        kTintedMesh + kIndexedFan + "Buffer filed uint faces.raw\nVertices triangles indices filed\n";
    TextScene ofFile(scene, {{"faces.raw", faces}});
    EXPECT_EQ(ofFile.draw().data, bytesOf(kIndexedFan + "Vertices triangles indices faces\n"));
    faces[4] = 9;
    EXPECT_NE(refusalOf(scene, {{"faces.raw", faces}})
                  .find("Vertices: element 1 of 'filed' is vertex 9, but 'hub' has 7 elements [memory-E13]"),
              std::string::npos)
        << refusalOf(scene, {{"faces.raw", faces}});
}

TEST(ScriptIndices, InstancesDrawThemSeveralTimes) {
    const std::string shifts = "Buffer shifts vec2 [-.1 0  .2 .1]\nAttribute aShift shifts per instance\n";
    const std::vector<std::byte> twice =
        bytesOf(kIndexedFan + shifts + "Instances 2\nVertices triangles indices faces\n");
    EXPECT_EQ(bytesOf(kIndexedFan + "Attribute aShift -.1 0\nVertices triangles indices faces\n"
                                    "Attribute aShift .2 .1\nVertices triangles indices faces\n"),
              twice);
    EXPECT_EQ(bytesOf(kIndexedFan + shifts +
                      "Buffer n uint [2]\nInstances from n\nVertices triangles indices faces\n"),
              twice);
}

TEST(ScriptIndices, TheLargestValueBeginsAStripAnew) {
    const std::string places =
        "Buffer grid vec2 8 (vec2(-.8 + .5*floor(i/2), -.5 + mod(i, 2)))\n"
        "Attribute aPlace grid\nAttribute aTint 1 .5 0\n";
    const std::vector<std::byte> apart =
        bytesOf(places +
                "Buffer a uint [0 1 2 3]\nVertices triangle_strip indices a\n"
                "Buffer b uint [4 5 6 7]\nVertices triangle_strip indices b\n");
    EXPECT_EQ(bytesOf(places + "Buffer a uint [0 1 2 3 4294967295 4 5 6 7]\n"
                               "Vertices triangle_strip indices a\nExpect primitives 4\n"),
              apart);
    EXPECT_EQ(bytesOf(places + "Buffer a int [0 1 2 3 -1 4 5 6 7]\nVertices triangle_strip indices a\n"),
              apart);
    EXPECT_NE(bytesOf(places + "Buffer a uint [0 1 2 3 4 5 6 7]\nVertices triangle_strip indices a\n"),
              apart);
    EXPECT_EQ(problemsOf(kTintedMesh + places +
                         "Buffer a uint [0 1 2 3 4294967295 4 5 6 7]\nVertices line_loop indices a\n"
                         "Expect primitives 8\n"),
              "");
    // What follows without indices is drawn as ever.
    EXPECT_EQ(bytesOf(places + "Buffer a uint [0 1 2 3 4294967295 4 5 6 7]\n"
                               "Vertices triangle_strip indices a\nVertices triangle_strip 4\n"),
              apart);
}

TEST(ScriptIndices, AShaderMayWriteThem) {
    if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    const std::string begin = kIndexedFan + R"(Buffer made uint 18
Compute inline
#version 430 core
layout(local_size_x = 18) in;
layout(std430) readonly buffer faces { uint from[]; };
layout(std430) writeonly buffer made { uint to[]; };
void main() { to[gl_LocalInvocationIndex] = from[gl_LocalInvocationIndex]; }
EndCompute
Program Copy
)";
    const std::string end = "Use P\nVertices triangles indices made\n";
    const std::vector<std::byte> singly = bytesOf(kUnindexedFan + "Vertices triangles 18\n");
    EXPECT_EQ(bytesOf(begin + "Dispatch Copy 1\n" + end), singly);
    EXPECT_EQ(bytesOf(begin + "Dispatch Copy 1\n" + end, false), singly);
    EXPECT_EQ(bytesOf(begin + "Once\nDispatch Copy 1\nEndOnce\n" + end), singly);
    TextScene stepping(kTintedMesh + begin + "Step 10\nDispatch Copy 1\nEndStep\n" + end);
    EXPECT_NE(stepping.draw(0).data, singly);
    EXPECT_EQ(stepping.draw(.1).data, singly);
}

TEST(ScriptIndices, OnlyTheBufferOfASeenDrawIsMade) {
    const SceneFolder folder(kTintedMesh + kIndexedFan +
                             "Texture2D unseen 8 8 rgba8\nBuffer other uint [0 1 2]\nPass unseen\n"
                             "Vertices triangles indices other\nEndPass\n"
                             "Vertices triangles indices faces\n");
    const BothWays both = drawBothWays(folder);
    EXPECT_EQ(both.skipping.count("buffers"), 3U);
    EXPECT_EQ(both.whole.count("buffers"), 4U);
}

TEST(ScriptIndices, AdjacencyIsOfTheTopology) {
    const std::string scene = R"(WindowSize 16 16
Vertex inline
#version 410 core
in vec2 aPlace;
void main() { gl_Position = vec4(aPlace, 0, 1); }
EndVertex
Geometry inline
#version 410 core
layout(triangles_adjacency) in;
layout(triangle_strip, max_vertices = 3) out;
void main() {
    for (int i = 1; i < 6; i += 2) { gl_Position = gl_in[i].gl_Position; EmitVertex(); }
}
EndGeometry
Fragment inline
#version 410 core
out vec4 c;
void main() { c = vec4(1, 0, 0, 1); }
EndFragment
Program P
Use P
Buffer places vec2 [0 0  -1 -1  3 -1  -1 3]
Buffer six uint [0 1 0 2 0 3]
Attribute aPlace places
)";
    EXPECT_EQ(problemsOf(scene + "Vertices triangles_adjacency indices six\nExpect pixel 8 8 [1 0 0]\n"
                                 "Expect primitives 1\n"),
              "");
    const std::string refused = refusalOf(scene + "Vertices triangles indices six\n");
    EXPECT_NE(refused.find("expects triangles_adjacency; use Vertices triangles_adjacency [draw-E02]"),
              std::string::npos)
        << refused;
}

TEST(ScriptIndices, PatchesTakeThem) {
    const std::string scene = R"(WindowSize 16 16
Vertex inline
#version 410 core
in vec2 aPlace;
void main() { gl_Position = vec4(aPlace, 0, 1); }
EndVertex
TessEvaluation inline
#version 410 core
layout(triangles) in;
void main() {
    gl_Position = gl_TessCoord.x * gl_in[0].gl_Position + gl_TessCoord.y * gl_in[1].gl_Position +
                  gl_TessCoord.z * gl_in[2].gl_Position;
}
EndTessEvaluation
Fragment inline
#version 410 core
out vec4 c;
void main() { c = vec4(1, 0, 0, 1); }
EndFragment
Program P
Use P
Buffer places vec2 [9 9  -1 -1  3 -1  -1 3]
Buffer three uint [1 2 3]
Attribute aPlace places
NumPatchVertices 3
Vertices patches indices three
Expect count [1 0 0] 256
)";
    EXPECT_EQ(problemsOf(scene), "");
    const std::string beyond =
        refusalOf(scene + "Buffer end uint [1 2 4294967295]\nVertices patches indices end\n");
    EXPECT_NE(beyond.find("element 2 of 'end' is vertex 4294967295, but 'places' has 4 elements"),
              std::string::npos)
        << beyond;
}

TEST(ScriptIndices, WrongOnesAreRefused) {
    const auto refused = [](const std::string& text) { return refusalOf(kTintedMesh + kIndexedFan + text); };
    const auto expect = [&](const std::string& text, const std::string& message) {
        EXPECT_NE(refused(text).find(message), std::string::npos) << text << refused(text);
    };
    expect("Vertices triangles indices fasces\n",
           "'fasces' is declared before this line; did you mean 'faces'?");
    expect("Vertices triangles indices hub\n",
           "24:28: error: Vertices: 'hub' holds vec2, but indices are uint or int [glib-E33]");
    expect("Vertices triangles 21 indices faces\n",
           "24:20: error: Vertices: 21 indices are more than the 18 of 'faces' [glib-E05]");
    expect("Buffer far uint [0 1 2  0 7 1]\nVertices triangles indices far\n",
           "Vertices: element 4 of 'far' is vertex 7, but 'hub' has 7 elements [memory-E13]");
    expect("Buffer less int [0 1 -2]\nVertices triangles indices less\n",
           "Vertices: element 2 of 'less' is vertex -2, but 'hub' has 7 elements [memory-E13]");
    const std::string filed =
        kTintedMesh + kIndexedFan + "Buffer filed uint a.raw\nVertices triangles 3 indices filed\n";
    const std::string two("\0\0\0\0\1\0\0\0", 8);
    EXPECT_NE(refusalOf(filed, {{"a.raw", two}})
                  .find("Vertices: 3 indices are more than the 2 of buffer 'filed' [memory-E13]"),
              std::string::npos)
        << refusalOf(filed, {{"a.raw", two}});
    const std::string all =
        kTintedMesh + kIndexedFan + "Buffer filed uint a.raw\nVertices triangles indices filed\n";
    EXPECT_NE(refusalOf(all, {{"a.raw", "abc"}})
                  .find("Vertices: buffer 'filed' is empty, so it has no indices [memory-E13]"),
              std::string::npos)
        << refusalOf(all, {{"a.raw", "abc"}});
    // Only the elements that are drawn count.
    EXPECT_NE(bytesOf(kIndexedFan + "Buffer far uint [0 1 2  0 7 1]\nVertices triangles 3 indices far\n"),
              bytesOf(kIndexedFan));
}

TEST(ScriptIndices, BuffersHaveAnElementForEachVertexAndInstance) {
    const auto expect = [](const std::string& text, const std::string& message) {
        const std::string refused = refusalOf(kTintedMesh + kIndexedFan + text);
        EXPECT_NE(refused.find(message), std::string::npos) << text << refused;
    };
    expect("Vertices triangles 9\n",
           "24:1: error: Vertices: 9 vertices are more than the 7 elements of 'hub' [memory-E13]");
    const std::string shifts = "Buffer shifts vec2 2\nAttribute aShift shifts per instance\n";
    expect(shifts + "Instances 3\nVertices triangles 6\n",
           "27:1: error: Vertices: 3 instances are more than the 2 elements of 'shifts' [memory-E13]");
    expect(shifts + "Instances 3\nVertices triangles indices faces\n",
           "Vertices: 3 instances are more than the 2 elements of 'shifts' [memory-E13]");
    expect(shifts + "Instances 3\nCube\n", "Cube: 3 instances are more than");
    const auto drawn = [](const std::string& text) { return problemsOf(kTintedMesh + kIndexedFan + text); };
    EXPECT_EQ(drawn(shifts + "Instances 2\nVertices triangles 7\n"), "");
    EXPECT_EQ(drawn(shifts + "Instances 2\nVertices triangles indices faces\n"), "");
    EXPECT_EQ(drawn(shifts + "Buffer n uint [3]\nInstances from n\nVertices triangles 6\n"), "");
    EXPECT_EQ(drawn("Buffer n uint [9]\nVertices triangles from n\n"), "");
}

TEST(ScriptIndices, ACountFromABufferIsNeverBeyondTheIndices) {
    // A driver that reads beyond the end of the indices may crash.
    for (const char* count : {"19", "20", "1000", "4096", "70000", "5000000", "400000000"}) {
        const std::string found = problemsOf(kTintedMesh + kIndexedFan + "Buffer n uint [" + count +
                                             "]\nVertices triangles from n indices faces\n");
        EXPECT_NE(found.find("indices are more than the 18 elements of 'faces' [memory-E15]"),
                  std::string::npos)
            << count << found;
    }
    const std::string above = kTintedMesh + kIndexedFan + "Buffer n uint [500000001]\n";
    EXPECT_NE(problemsOf(above + "Vertices triangles from n indices faces\n").find("memory-E06"),
              std::string::npos);
    for (const char* count : {"0", "1", "17", "18"})
        EXPECT_EQ(problemsOf(kTintedMesh + kIndexedFan + "Buffer n uint [" + count +
                             "]\nVertices triangles from n indices faces\n"),
                  "")
            << count;
    // Attributes of vertices beyond their buffer read zeros, and crash nothing.
    EXPECT_EQ(problemsOf(kTintedMesh + kIndexedFan + "Buffer n uint [3000000]\nVertices triangles from n\n"),
              "");
    EXPECT_EQ(problemsOf(kTintedMesh + kIndexedFan +
                         "Buffer shifts vec2 2\n"
                         "Attribute aShift shifts per instance\n"
                         "Buffer n uint [300000]\nInstances from n\n"
                         "Vertices triangles 6 indices faces\n"),
              "");
}

TEST(ScriptAttributes, AMisspeltOneIsSuggested) {
    const auto found = [](const std::string& input, const std::string& statements) {
        return problemsOf("WindowSize 8 8\nVertex inline\n#version 410 core\nin vec2 aPlace;\nin vec3 " +
                          input + ";\nvoid main() { gl_Position = vec4(aPlace + " + input +
                          ".xy, 0, 1); }\nEndVertex\nFragment inline\n#version 410 core\nout vec4 c;\n"
                          "void main() { c = vec4(1); }\nEndFragment\nProgram P\nUse P\n"
                          "Buffer places vec2 3\nAttribute aPlace places\n" +
                          statements + "Vertices triangles 3\n");
    };
    EXPECT_NE(
        found("aOffset", "Attribute aOfset 0 0 0\n")
            .find("vertex input 'aOffset' is not supplied; it reads 0 0 0 1; did you mean the attribute "
                  "'aOfset'? [draw-W03]"),
        std::string::npos)
        << found("aOffset", "Attribute aOfset 0 0 0\n");
    EXPECT_EQ(found("aOffset", "Attribute aOffset 0 0 0\n"), "");
    EXPECT_NE(found("aVertexNormla", "").find("0 0 0 1; did you mean 'aVertexNormal'? [draw-W03]"),
              std::string::npos)
        << found("aVertexNormla", "");
    EXPECT_NE(found("aFar", "").find("it reads 0 0 0 1 [draw-W03]"), std::string::npos) << found("aFar", "");
    EXPECT_NE(found("aPlaces", "").find("it reads 0 0 0 1 [draw-W03]"), std::string::npos)
        << "aPlace feeds another input";
}

TEST(ScriptIndices, ABlockThatSpreadsThemIsRefused) {
    const std::string scene = kTintedMesh + kIndexedFan + R"(Buffer spread uint [0 1 2 3]
Fragment inline
#version 410 core
layout(std140) uniform spread { uint n[4]; };
out vec4 c;
void main() { c = vec4(n[1]); }
EndFragment
Program Q
Use Q
Vertices triangles 3
Use P
Vertices triangles 3 indices spread
)";
    const std::string refused = refusalOf(scene);
    EXPECT_NE(refused.find("indices are uint or int, one after another; uniform block 'spread' lays out "
                           "buffer 'spread' otherwise [memory-E13]"),
              std::string::npos)
        << refused;
}

}  // namespace
}  // namespace glibra::test
