// Dispatches, images, subroutines, stages and vertices of modern scenes, by scenes whose Expect lines must
// hold.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "render/conductor.h"
#include "script_problems.h"

namespace glibra::test {
namespace {

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

// ---- The driver's units.

TEST(DriverLimits, ComeFromTheDriver) {
    gpu::Capabilities driver;
    driver.major = 4;
    driver.minor = 1;
    driver.combinedTextureUnits = 17;
    driver.imageUnits = 33;
    for (const bool isSoftware : {true, false}) {
        driver.isSoftware = isSoftware;
        const plan::PlanOptions made = render::planOptionsOf(driver);
        EXPECT_EQ(made.maxTextureUnits, 17);
        EXPECT_EQ(made.maxImageUnits, 33);
        EXPECT_EQ(made.cutsDispatches, !isSoftware);
        EXPECT_NE(made.lacksCompute, "");
    }
}

TEST(DriverLimits, AsManyImagesAsTheDriverHasUnits) {
    GLint ofCompute = 0;
    glGetIntegerv(GL_MAX_COMPUTE_IMAGE_UNIFORMS, &ofCompute);
    const int most = std::min({sharedContext().capabilities().imageUnits, static_cast<int>(ofCompute), 16});
    for (int count = 7; count <= most; ++count) {
        std::string textures, uniforms, stores, values, expected;
        for (int i = 0; i < count; ++i) {
            const std::string name = std::to_string(i);
            textures += "Texture2D image" + name + " 1 1 r32f\n";
            uniforms += "layout(r32f) uniform writeonly image2D uImage" + name + ";\n";
            stores += "imageStore(uImage" + name + ", ivec2(0), vec4(" + std::to_string(i + 1) + ".));\n";
            values += " uImage" + name + " image" + name;
            expected += "Expect pixel 0 0 [" + std::to_string(i + 1) + "] of image" + name + "\n";
        }
        EXPECT_EQ(problemsOf(textures + "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\n" +
                             uniforms + "void main() {\n" + stores + "}\nEndCompute\nProgram Write" + values +
                             "\nDispatch Write 1 1 1\n" + expected),
                  "")
            << count;
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

constexpr const char* kShades = R"(Fragment inline
#version 400 core
subroutine vec4 Shade(float level);
subroutine uniform Shade shade;
subroutine(Shade) vec4 red(float level) { return vec4(level, 0., 0., 1.); }
subroutine(Shade) vec4 green(float level) { return vec4(0., level, 0., 1.); }
out vec4 fColor;
uniform float uLevel;
void main() { fColor = shade(uLevel); }
EndFragment
)";

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
    const std::string scene = "WindowSize 4 4\nLet some 1\nTexture2D kept 4 4 rgba8 nearest\n" +
                              std::string(kShades) +
                              R"(Program P shade red uLevel (some)
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
    const std::string shader = std::string("Let some 1\n") + kShades;
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
Expect error memory-W05
)"),
              "");
}

// ---- Names of the book's shaders that a compiler may know otherwise.

TEST(BookNames, OfAPointsSizeBelongsToTheVertexStageAndNewIsAVariable) {
    const auto problems = [](const std::string& fragment) {
        return problemsOf(
            "LookAt 0 0 4 0 0 0 0 1 0\nFragment inline\n#version 330 core\nout vec4 f;\nvoid main() { " +
            fragment +
            " }\nEndFragment\nVertex inline\n#version 330 core\nvoid main() { gl_PointSize = 2.; "
            "gl_Position = vec4(aVertex.xy, 0., 1.); }\nEndVertex\nProgram P\nQuadXY 0 1\n");
    };
    EXPECT_EQ(problems("float new = .5; f = vec4(new);"), "");
    EXPECT_NE(problems("gl_PointSize = 2.; f = vec4(1.);").find("gl_PointSize' undeclared"),
              std::string::npos)
        << problems("gl_PointSize = 2.; f = vec4(1.);");
}

}  // namespace
}  // namespace glibra::test
