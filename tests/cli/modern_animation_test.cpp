// Modern scenes with steps and history as a user draws them: whole, in parts, frame by frame, by EGL and
// OSMesa, with one thread and two. And what a driver without compute shaders says.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "program.h"

namespace glibra::test {
namespace {

constexpr const char* kLife = R"(WindowSize 70 50
Texture2D life 70 50 r8ui history
Compute inline
#version 430 core
layout(local_size_x = 8, local_size_y = 8) in;
layout(r8ui) writeonly uniform uimage2D uOut;
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    uint h = uint(at.x) * 73856093u ^ uint(at.y) * 19349663u;
    imageStore(uOut, at, uvec4((((h ^ (h >> 13)) * 1274126177u) >> 16) & 1u));
}
EndCompute
Program Seed uOut life
Compute inline
#version 430 core
layout(local_size_x = 8, local_size_y = 8) in;
uniform usampler2D uIn;
layout(r8ui) writeonly uniform uimage2D uOut;
void main() {
    ivec2 size = textureSize(uIn, 0), at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, size))) return;
    uint n = 0u;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            if (x != 0 || y != 0) n += texelFetch(uIn, (at + ivec2(x, y) + size) % size, 0).r;
    imageStore(uOut, at, uvec4(n == 3u || (n == 2u && texelFetch(uIn, at, 0).r == 1u) ? 1u : 0u));
}
EndCompute
Program Generation uIn life.prev uOut life
Fragment inline
#version 430 core
uniform usampler2D uLife;
out vec4 fColor;
void main() { fColor = vec4(texelFetch(uLife, ivec2(gl_FragCoord.xy), 0).r); }
EndFragment
Program Show uLife life
Once
    Dispatch Seed over life
EndOnce
Step 10
    Dispatch Generation over life
EndStep
Fill window with Show
)";

// A spot that leaves a trail: each step darkens what the one before has drawn.
constexpr const char* kTrail = R"(WindowSize 70 50
Texture2D trail 70 50 rgba16f history linear
Fragment inline
#version 330 core
in vec2 vST;
uniform sampler2D uBefore;
uniform vec2 uAt;
out vec4 fColor;
void main() {
    vec4 before = texture(uBefore, vST + vec2(.004, 0.)) * .93;
    fColor = max(before, vec4(vec3(1., .7, .3) * smoothstep(.1, .05, distance(vST, uAt)), 1.));
}
EndFragment
Program Fade uBefore trail.prev uAt (.5 + .35 * vec2(cos(3 * time), sin(5 * time)))
Fragment inline
#version 330 core
in vec2 vST;
uniform sampler2D uMap;
uniform float uGlow;
out vec4 fColor;
void main() { fColor = vec4(texture(uMap, vST).rgb * uGlow, 1.); }
EndFragment
Program Show uMap trail uGlow (.8 + .2 * sin(7 * time))
Step 25
    Fill trail with Fade
EndStep
Fill window with Show
)";

constexpr int kFrames = 10;
constexpr const char* kAnimation = "render scene.glib --frames 10 --fps 8 ";

class Lasting : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override { folder.write("scene.glib", GetParam()); }

    /// The bytes of all frames.
    std::string film(const std::string& arguments, const std::string& environment = {}) {
        const Finished run = glibra(folder.path(), kAnimation + arguments + " -o film.png", environment);
        EXPECT_EQ(run.status, 0) << run.err;
        std::string all;
        for (int i = 0; i < kFrames; ++i) all += readFile(folder / ("film_000" + std::to_string(i) + ".png"));
        return all;
    }

    Folder folder;
};

TEST_P(Lasting, IsTheSameWholeInPartsAndFrameByFrame) {
    const std::string whole = film("");
    std::set<std::string> different;
    for (int i = 0; i < kFrames; ++i)
        different.insert(readFile(folder / ("film_000" + std::to_string(i) + ".png")));
    EXPECT_EQ(different.size(), static_cast<std::size_t>(kFrames)) << "every frame moves";
    EXPECT_EQ(film("--jobs 2"), whole);
    EXPECT_EQ(film("--no-skip"), whole);
    for (const int i : {9, 4, 0}) {
        const Finished one =
            glibra(folder.path(), "render scene.glib -o one.png --time " + std::to_string(i / 8.));
        ASSERT_EQ(one.status, 0) << one.err;
        const Finished same =
            glibra(folder.path(), "compare --exact one.png film_000" + std::to_string(i) + ".png");
        EXPECT_EQ(same.status, 0) << i << same.out;
    }
}

TEST_P(Lasting, IsTheSameForEveryWayToTheDriver) {
    const std::string egl = film("--driver egl", "LP_NUM_THREADS=1");
    EXPECT_EQ(film("--driver egl", "LP_NUM_THREADS=2"), egl);
    if (!hasOsmesa()) GTEST_SKIP() << kNoOsmesa;
    EXPECT_EQ(film("--driver osmesa", "LP_NUM_THREADS=2"), egl);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Lasting, testing::Values(kLife, kTrail),
                         [](const testing::TestParamInfo<const char*>& scene) {
                             return std::string(scene.index == 0 ? "Life" : "Trail");
                         });

constexpr const char* kOld = "MESA_GL_VERSION_OVERRIDE=4.1";

/// The checks of scene.glib hold on GL 4.1, and its picture has the same bytes there.
void expectEqualOnGl41(const Folder& folder) {
    const Finished old = glibra(folder.path(), "check --run scene.glib", kOld);
    EXPECT_EQ(old.status, 0) << old.err;
    ASSERT_EQ(glibra(folder.path(), "render scene.glib -o old.png", kOld).status, 0);
    ASSERT_EQ(glibra(folder.path(), "render scene.glib -o new.png").status, 0);
    EXPECT_EQ(readFile(folder / "old.png"), readFile(folder / "new.png"));
}

TEST(WithoutCompute, OneMessageNamesWhatIsMissing) {
    const Folder folder;
    folder.write("scene.glib", kLife);
    const Finished run = glibra(folder.path(), "render scene.glib -o a.png", kOld);
    EXPECT_EQ(run.status, 3);
    EXPECT_EQ(
        run.err,
        "scene.glib:38:5: error: Dispatch needs a driver with OpenGL 4.3; this one has 4.1 [memory-E01]\n");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
    const Finished checked = glibra(folder.path(), "check scene.glib", kOld);
    EXPECT_EQ(checked.status, 3);
    EXPECT_EQ(checked.err, run.err);
    // Steps that draw need no compute shader.
    folder.write("scene.glib", kTrail);
    EXPECT_EQ(glibra(folder.path(), "render scene.glib -o a.png --time 1", kOld).status, 0);
    // Neither does a buffer that nothing stores to, but a storage block does.
    folder.write("scene.glib", R"(WindowSize 8 8
Buffer all float [1 2 3]
Fragment inline
#version 430 core
layout(std430) readonly buffer all { float a[]; };
out vec4 fColor;
void main() { fColor = vec4(a[1]); }
EndFragment
Program Show
Fill window with Show
)");
    EXPECT_EQ(
        glibra(folder.path(), "render scene.glib -o b.png", kOld).err,
        "scene.glib:5:32: error: buffer block 'all' needs GLSL 4.30, this driver has 4.10 [glsl-E03]\n");
    // The kinds of outputs and targets are compared without the driver's list of outputs.
    folder.write("scene.glib", R"(WindowSize 8 8
Texture2D ids 8 8 r32ui
Fragment inline
#version 410 core
out vec4 fId;
void main() { fId = vec4(1); }
EndFragment
Program Write
Fill ids with Write
)");
    EXPECT_EQ(glibra(folder.path(), "check scene.glib", kOld).err,
              "scene.glib:9:1: error: fragment output 'fId' is of type vec4, but target 'ids' (line 2) holds "
              "unsigned integers; declare the output as uvec4 [draw-E11]\n");
    // Images need OpenGL 4.2, even if the driver lists their extension.
    folder.write("scene.glib", R"(WindowSize 8 8
Texture2D heads 8 8 r32ui
Fragment inline
#version 430 core
layout(r32ui) uniform uimage2D heads;
out vec4 fColor;
void main() { imageStore(heads, ivec2(gl_FragCoord.xy), uvec4(7)); fColor = vec4(1.); }
EndFragment
Program Show
Fill window with Show
)");
    EXPECT_EQ(glibra(folder.path(), "render scene.glib -o c.png", kOld).err,
              "scene.glib:5:23: error: uimage2D needs GLSL 4.20, this driver has 4.10 [glsl-E03]\n"
              "scene.glib:7:15: error: imageStore needs GLSL 4.20, this driver has 4.10 [glsl-E03]\n");
}

TEST(WithoutCompute, IndicesBufferTexturesAndArraysOfCubeMapsAreNotMissing) {
    const Folder folder;
    folder.write("scene.glib", R"(WindowSize 32 32
Background 0 0 0
Buffer places vec2 [-1 -1  1 -1  -1 0  1 0  -1 1  1 1]
Buffer strips uint [0 1 2 3 4294967295 3 4 5]
Buffer colors vec4 [1 0 0 1  0 1 0 1]
CubeMap sky 4 rgba8 layers 2
Pass sky.layer(1).face(0) clear {0 0 1 1}
EndPass
Vertex inline
#version 410 core
in vec2 aPlace;
out vec2 vPlace;
void main() { vPlace = aPlace; gl_Position = vec4(aPlace, 0, 1); }
EndVertex
Fragment inline
#version 410 core
uniform samplerBuffer colors;
uniform samplerCubeArray sky;
in vec2 vPlace;
out vec4 fColor;
void main() { fColor = texelFetch(colors, vPlace.x < 0. ? 0 : 1) + texture(sky, vec4(1, 0, 0, 1)); }
EndFragment
Program P
Use P
Attribute aPlace places
Vertices triangle_strip indices strips
Expect primitives 3
Expect pixel 3 3 [1 0 1]
Expect pixel 28 28 [0 1 1]
Expect pixel 3 18 [0 0 0]
Expect pixel 3 28 [0 0 0]
)");
    expectEqualOnGl41(folder);
}

TEST(WithoutCompute, ArraysOfSamplesAnd1DTexturesAndRectanglesAreNotMissing) {
    const Folder folder;
    folder.write("scene.glib", R"(WindowSize 32 32
Fragment inline
#version 410 core
uniform float uRed;
out vec4 fColor;
void main() { fColor = vec4(uRed, float(gl_SampleID) / 3., gl_FragCoord.x / 8., 1); }
EndFragment
Program Paint
Texture1DArray ramps 8 3 rgba8 nearest history
Texture2DArray soft 8 8 2 rgba8 samples 4 history
TextureRect rect 8 8 rgba8 nearest history
Repeat 3 as n
    Fill ramps.layer(n) with Paint uRed (n/2)
EndRepeat
Fill soft.layer(1) with Paint uRed .5
Fill rect with Paint uRed .75
Fragment inline
#version 410 core
uniform sampler1DArray ramps;
uniform sampler2DArray soft;
uniform sampler2DMSArray uSamples;
uniform sampler2DRect rect;
in vec2 vST;
out vec4 fColor;
void main() {
    fColor = vec4(texture(ramps, vec2(vST.x, 2)).b, texture(soft, vec3(vST, 1)).g,
                  texelFetch(uSamples, ivec3(1, 1, 1), 3).g * texture(rect, vec2(2.5, 6)).r, 1);
}
EndFragment
Program Show uSamples soft
Fill window with Show
Expect pixel 1 1 [.0625 .5 .75] within .003
Expect pixel 30 1 [.9375 .5 .75] within .003
Expect mean 0 0 8 1 [.5 0 .5] of ramps.layer(1) within .003
)");
    expectEqualOnGl41(folder);
}

TEST(WithoutCompute, TheOtherShotsOfASuiteGoOn) {
    const Folder folder;
    folder.write("life.glib", kLife);
    folder.write("trail.glib", kTrail);
    folder.write("suite.toml",
                 "goldens = \"goldens\"\n[defaults]\ntime = 1\n[[shot]]\nscript = \"life.glib\"\n"
                 "[[shot]]\nscript = \"trail.glib\"\n");
    ASSERT_EQ(glibra(folder.path(), "test suite.toml --update").status, 0);
    const Finished old = glibra(folder.path(), "test suite.toml", kOld);
    EXPECT_EQ(old.status, 3) << old.out;
    EXPECT_NE(old.out.find("1 failed, 1 passed"), std::string::npos) << old.out << old.err;
    EXPECT_NE((old.out + old.err).find("[memory-E01]"), std::string::npos) << old.out << old.err;
}

}  // namespace
}  // namespace glibra::test
