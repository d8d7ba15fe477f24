// What a frame of an animation takes over from the frame before, and what its textures share: each picture
// has the bytes of a scene that is loaded for it alone and skips nothing.

#include <glibra/render.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "gpu/context/call_counter.h"
#include "gpu/context/context.h"
#include "render/scene_renderer.h"

namespace glibra::test {
namespace {

/// `Show` shows the texture uA, `Both` half of uA and half of uB.
constexpr const char* kShow = R"(WindowSize 24 16
Camera eye LookAt 0 0 3  0 0 0  0 1 0  Ortho -1 1 -1 1 .1 10
Camera light LookAt 0 0 3  0 0 0  0 1 0  Ortho -1 1 -1 1 .1 10
Fragment inline
#version 430 core
uniform sampler2D uA;
in vec2 vST;
out vec4 fColor;
void main() { fColor = vec4(texture(uA, vST).rgb, 1.); }
EndFragment
Program Show
Fragment inline
#version 430 core
uniform sampler2D uA, uB;
in vec2 vST;
out vec4 fColor;
void main() { fColor = vec4((vST.x < .5 ? texture(uA, vST) : texture(uB, vST)).rgb, 1.); }
EndFragment
Program Both
)";
const std::string kPlacedVertex = R"(
Vertex inline
#version 430 core
uniform mat4 mvp_matrix;
in vec3 vertPos;
void main() { gl_Position = mvp_matrix * vec4(vertPos, 1.); }
EndVertex
)";
/// `Flat` draws with uColor.
const std::string kFlatProgram = kPlacedVertex + R"(Fragment inline
#version 430 core
uniform vec4 uColor;
out vec4 fColor;
void main() { fColor = uColor; }
EndFragment
Program Flat uColor {1 1 1}
)";

class KeptFrames : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  (std::string("kept_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(folder_);
        Result<gpu::Context> context = gpu::openContext({});
        ASSERT_TRUE(context);
        context_.emplace(std::move(*context));
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// Draws the scene at these times, one after another, and compares each picture with that of a scene that
    /// is loaded for this time alone. `programs` are declared before Flat.
    void draw(const std::string& statements, const std::vector<double>& times,
              const std::string& programs = {}) {
        write(kShow + programs + kFlatProgram + statements);
        stats = {};
        Result<render::SceneRenderer> scene = load({});
        ASSERT_TRUE(scene) << (scene.diagnostics.empty() ? "" : scene.diagnostics.front().text);
        for (const double time : times) {
            const Result<image::Image> picture = scene->draw(time, stats);
            ASSERT_TRUE(picture);
            RenderOptions whole;
            whole.skip = false;
            render::Stats unused;
            Result<render::SceneRenderer> alone =
                render::SceneRenderer::load(*context_, path(), whole, unused);
            ASSERT_TRUE(alone);
            const Result<image::Image> wanted = alone->draw(time, unused);
            ASSERT_TRUE(wanted);
            EXPECT_TRUE(picture->data == wanted->data) << "at " << time;
            EXPECT_EQ(counted(unused, render::kStillPasses), 0U);
        }
    }
    void write(const std::string& scene) const { std::ofstream(path()) << scene; }
    Result<render::SceneRenderer> load(const RenderOptions& options) {
        return render::SceneRenderer::load(*context_, path(), options, stats);
    }
    static std::uint64_t counted(const render::Stats& stats, std::string_view name) {
        for (const auto& each : stats.counts)
            if (each.name == name) return each.value;
        return 0;
    }
    [[nodiscard]] std::uint64_t count(std::string_view name) const { return counted(stats, name); }

    render::Stats stats;

  private:
    [[nodiscard]] std::filesystem::path path() const { return folder_ / "scene.glib"; }

    std::filesystem::path folder_;
    std::optional<gpu::Context> context_;
};

TEST_F(KeptFrames, TheShadowMapOfAStillLightIsDrawnOnce) {
    draw(R"(
Texture2D map 16 16 depth32f nearest
Group caster
    Translate .2 0 0
    Box .5
EndGroup
Pass map from light
    Draw caster
EndPass
Fill window with Show uA map
Pass window from eye
    Use Flat
    Translate (.1*time) -.5 0
    Box .2
EndPass
)",
         {0, 1, 2, 3});
    EXPECT_EQ(count(render::kStillPasses), 3U);
}

TEST_F(KeptFrames, AMovingCasterIsDrawnInEveryFrame) {
    draw(R"(
Texture2D map 16 16 depth32f nearest
Pass map from light
    Translate (.2*time) 0 0
    Box .5
EndPass
Fill window with Show uA map
)",
         {0, 1, 2});
    EXPECT_EQ(count(render::kStillPasses), 0U);
}

TEST_F(KeptFrames, WhatReadsAChangedPassIsDrawnAgain) {
    draw(R"(
Texture2D a 8 8 rgba8 nearest
Texture2D b 8 8 rgba8 nearest
Texture2D c 8 8 rgba16f nearest
Pass a clear {.1 .2 .3}
    Set uColor (vec4(.2*time, 1, 0, 1))
    Box 1
EndPass
Fill b with Show uA a
Pass c clear {.5 0 0}
    Box 1
EndPass
Fill window with Both uA b uB c
)",
         {0, 1, 2, 2.5});
    EXPECT_EQ(count(render::kStillPasses), 3U) << "only the pass into c is still";
}

TEST_F(KeptFrames, AFrameDoesNotSeeWhatEarlierOnesHaveDrawn) {
    const char* statements = R"(
Texture2D a 8 8 rgba8 nearest
When (time < 1.5)
    Pass a clear {1 .5 0}
        Box (.5 + .1*time)
    EndPass
EndWhen
Fill window with Show uA a
)";
    draw(statements, {0, 1, 2, 3, 1, 0, 2});
}

TEST_F(KeptFrames, AStillPassThatEndsAndBeginsAgainIsDrawnAgain) {
    draw(R"(
Texture2D a 8 8 rgba8 nearest
When (mod(floor(time), 2.) < .5)
    Pass a clear {0 .5 1}
        Box 1
    EndPass
EndWhen
Fill window with Show uA a
Pass window from eye
    Translate (.1*time) 0 0
    Box .2
EndPass
)",
         {0, .25, 1, 1.5, 2, 2.5});
    EXPECT_EQ(count(render::kStillPasses), 2U) << "at .25 and 2.5";
}

TEST_F(KeptFrames, TexturesThatAreNotNeededAtTheSameTimeShareMemory) {
    const std::string chain = R"(
Texture2D a 8 8 rgba8 nearest
Texture2D b 8 8 rgba8 nearest
Texture2D c 8 8 rgba8 nearest
Texture2D d 8 8 rgba16f nearest
Pass a clear {0 .5 1}
    Box 1
EndPass
Fill b with Show uA a
Fill c with Show uA b
Fill d with Show uA c
)";
    draw(chain + "Fill window with Show uA d\n", {0, 1});
    EXPECT_EQ(count("textures that share memory"), 1U) << "c that of a; d has another format";
    EXPECT_EQ(count("textures"), 3U);
    draw(chain + R"(
Fill window with Both uA d uB a
)",
         {0});
    EXPECT_EQ(count("textures that share memory"), 0U) << "a is needed until the end";
}

TEST_F(KeptFrames, TexturesGetMemoryOfTheirOwnWhenTheyMeet) {
    draw(R"(
Texture2D a 8 8 rgba8 nearest
Texture2D b 8 8 rgba8 nearest
Texture2D c 8 8 rgba8 nearest
Pass a clear {0 .5 1}
    Box 1
EndPass
Fill b with Show uA a
Fill c with Show uA b
When (time > .5)
    Fill window with Both uA c uB a
Else
    Fill window with Show uA c
EndWhen
)",
         {0, 1, 0, 1});
    EXPECT_EQ(count("textures that share memory"), 1U) << "c until 1, then it keeps memory of its own";
}

TEST_F(KeptFrames, WhatReadsAStepIsDrawnWhenAStepHasRun) {
    const char* programs = R"(
Buffer Count uint [0]
Compute inline
#version 430 core
layout(local_size_x = 1) in;
layout(std430) buffer Count { uint count; };
void main() { count += 40u; }
EndCompute
Program Add
Fragment inline
#version 430 core
layout(std430) readonly buffer Count { uint count; };
out vec4 fColor;
void main() { fColor = vec4(float(count) / 255., .5, 0., 1.); }
EndFragment
Program Number
)";
    draw(R"(
Texture2D a 8 8 rgba8 nearest
Step 1
    Dispatch Add 1 1 1
EndStep
Fill a with Number
Fill window with Show uA a
Pass window from eye
    Use Flat
    Translate (.1*time) 0 0
    Box .2
EndPass
)",
         {0, .25, .5, 1.25, 1.5, 3}, programs);
    EXPECT_EQ(count(render::kStillPasses), 3U) << "at .25, .5 and 1.5";
}

TEST_F(KeptFrames, ADispatchWithEqualInputsRunsOnce) {
    const char* programs = R"(
Buffer Level float 4
Let level <0. .5 1.>
Compute inline
#version 430 core
layout(local_size_x = 1) in;
uniform float uLevel;
layout(std430) buffer Level { float levels[]; };
void main() { levels[gl_GlobalInvocationID.x] += uLevel; }
EndCompute
Program Fill1 uLevel level
Fragment inline
#version 430 core
layout(std430) readonly buffer Level { float levels[]; };
uniform float uMore;
out vec4 fColor;
void main() { fColor = vec4(levels[1], uMore, levels[3], 1.); }
EndFragment
Program Number uMore (.1*time)
)";
    draw(R"(
Dispatch Fill1 over Level
Fill window with Number
)",
         {0, 1, 2, 3}, programs);
    EXPECT_EQ(count(render::kStillDispatches), 3U);
    EXPECT_EQ(count("dispatches"), 1U);
}

TEST_F(KeptFrames, AStepSetsNothingThatIsSet) {
    struct Row {
        std::string size, cut;
        std::uint64_t calls;
        std::string what;
    };
    // Graphics cards get every dispatch as one that may be cut; `tiles` makes it so on any driver.
    for (const auto& [size, cut, calls, what] :
         {Row{"64", "", 2, "dispatch, barrier"}, Row{"64", " tiles 2", 2, "one group: dispatch, barrier"},
          Row{"128", " tiles 2", 7, "twice a uniform, dispatch and flush; barrier"}}) {
        write("Buffer Level float " + size + R"(
Compute inline
#version 430 core
layout(local_size_x = 64) in;
uniform float uMore;
layout(std430) buffer Level { float levels[]; };
void main() { levels[gl_GlobalInvocationID.x] += uMore; }
EndCompute
Program More uMore .5
Fragment inline
#version 430 core
layout(std430) readonly buffer Level { float levels[]; };
out vec4 fColor;
void main() { fColor = vec4(levels[1] / 255.); }
EndFragment
Program Number
Step 1
    Dispatch More over Level)" +
              cut + R"(
EndStep
Fill window with Number
)");
        Result<render::SceneRenderer> scene = load({});
        ASSERT_TRUE(scene);
        const auto callsUntil = [&](double time) {
            const gpu::CallCounter counter;
            EXPECT_TRUE(scene->draw(time, stats));
            // Every few milliseconds a graphics card is waited for: a fence is made, waited for and deleted.
            return counter.counts().calls - 3 * counter.counts().fences;
        };
        callsUntil(10);
        const std::uint64_t few = callsUntil(20), many = callsUntil(130);
        EXPECT_EQ(many - few, 100U * calls) << what;
    }
}

TEST_F(KeptFrames, ADrawSetsNothingThatIsSet) {
    const auto callsFor = [this](int boxes) {
        write(std::string(kShow) + R"(
Texture2D a 8 8 rgba8 nearest
Texture2D b 8 8 rgba8 mipmap generate
Buffer Shades float [.25 .5]
)" + kPlacedVertex +
              R"(Fragment inline
#version 430 core
uniform sampler2D uA, uB;
uniform Tint { vec4 tint; };
layout(std430) readonly buffer Shades { float shades[]; };
out vec4 fColor;
void main() { fColor = tint * shades[1] + texture(uA, vec2(.5)) + textureLod(uB, vec2(.5), 2.); }
EndFragment
Program Textured tint {1 1 1} uA a uB b
Pass a clear {0 0 .5}
EndPass
Pass b clear {0 .25 0}
EndPass
Pass window from eye
    Use Textured
    Repeat )" +
              std::to_string(boxes) +
              R"( as k
        Translate (.01*k) 0 0
        Box .2
    EndRepeat
EndPass
)");
        Result<render::SceneRenderer> scene = load({});
        EXPECT_TRUE(scene);
        if (!scene) return std::uint64_t{0};
        EXPECT_TRUE(scene->draw(0, stats));
        const gpu::CallCounter counter;
        EXPECT_TRUE(scene->draw(0, stats));
        return counter.counts().calls;
    };
    const std::uint64_t few = callsFor(2), many = callsFor(12);
    EXPECT_EQ(many - few, 10U * 2U) << "the matrix and the draw";
}

TEST_F(KeptFrames, MipmapsAreMadeOnlyForSamplersThatReadThem) {
    const auto scene = [this](const std::string& filter, const std::string& read) {
        draw("Texture2D a 8 8 rgba8 " + filter + " generate\n" + R"(
Pass a clear {0 .5 1}
    Box .3
EndPass
Fill window with Read uA a
)",
             {0},
             "Fragment inline\n#version 430 core\nuniform sampler2D uA;\nin vec2 vST;\nout vec4 fColor;\n"
             "void main() { fColor = " +
                 read + "; }\nEndFragment\nProgram Read\n");
        return count("mipmaps made");
    };
    EXPECT_EQ(scene("linear", "texture(uA, vST)"), 0U);
    EXPECT_EQ(scene("linear", "textureLod(uA, vST, 2.)"), 0U) << "without a mipmap filter it reads level 0";
    EXPECT_EQ(scene("mipmap", "textureLod(uA, vST, 2.)"), 1U);
    EXPECT_EQ(scene("linear", "texelFetch(uA, ivec2(0), 3)"), 1U);
}

}  // namespace
}  // namespace glibra::test
