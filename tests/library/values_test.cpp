// Values that programs give to scenes: what fits a type, and what is refused.

#include <fmt/format.h>
#include <glibra/glibra.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support.h"

namespace glibra {
namespace {

namespace fs = std::filesystem;

using tests::firstPixel;
using tests::isIn;
using tests::kScenes;
using tests::kShaders;
using tests::kSquare;
using tests::opened;

/// A scene with a value of each kind of type; the picture is white where all have reached the shader.
constexpr const char* kTypes =
    "WindowSize 4 4\nVertex square.vert\nFragment types.frag\nLet near <0 1 9>\n"
    "Program Types uI 1 uU 1 uF 1 uIV [1 2] uUV [1 2 3] uFV [1 2] uM [1 0 0 1] uA [1 2 3 4] uD 1 uB <true> "
    "uN (near)\n"
    "QuadXY 0 10\n";
const std::map<std::string, std::string> kTypesShaders{
    {"square.vert", kShaders.at("square.vert")},
    {"types.frag",
     "#version 410\nuniform int uI; uniform uint uU; uniform float uF; uniform ivec2 uIV; uniform uvec3 "
     "uUV;\n"
     "uniform vec2 uFV; uniform mat2 uM; uniform int uA[4]; uniform double uD; uniform bool uB; uniform "
     "float uN;\n"
     "out vec4 color;\nvoid main() { color = vec4(float(uI) + float(uU) + uF + float(uIV.x + uIV.y) + "
     "float(uUV.x + uUV.y + uUV.z) + uFV.x + uM[1].y + float(uA[0] + uA[3]) + float(uD) + float(uB) + uN); "
     "}\n"}};

TEST(LibraryValues, CompilesShadersForTheValuesOfTheirConstants) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(
        "WindowSize 4 4\nLet level <0 2 5>\nFragment level.frag\nProgram P const LEVEL (level)\n"
        "Fill window with P\n",
        "constants.glib",
        {{"level.frag",
          "#version 330\n#define LEVEL 1\nout vec4 c;\n#if LEVEL > 2\nvec3 kind = vec3(0, 1, 0);\n#else\n"
          "vec3 kind = vec3(1, 0, 0);\n#endif\n"
          "void main() { float a[LEVEL]; c = vec4(kind * (float(a.length()) / 5.), 1.); }\n"}});
    ASSERT_TRUE(scene) << scene.message();
    const std::vector<std::pair<double, std::vector<int>>> shown{
        {2, {102, 0, 0}}, {4, {0, 204, 0}}, {2, {102, 0, 0}}, {5, {0, 255, 0}}};
    for (const auto& [level, color] : shown) {
        ASSERT_TRUE(scene->set("level", level));
        const Result<Picture> picture = scene->draw();
        ASSERT_TRUE(picture) << picture.message();
        EXPECT_EQ(firstPixel(*picture), color) << level;
    }
}

TEST(LibraryValues, RefusesNumbersThatTheTypeDoesNotHave) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(kTypes, "types.glib", kTypesShaders);
    ASSERT_TRUE(scene) << scene.message();
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    struct Case {
        const char* name;
        std::vector<double> numbers;
        bool isTaken;
    };
    for (const Case& each : std::vector<Case>{{"uI", {2147483647}, true},
                                              {"uI", {-2147483648.}, true},
                                              {"uI", {2147483648.}, false},
                                              {"uI", {3e9}, false},
                                              {"uI", {-2147483649.}, false},
                                              {"uI", {1e300}, false},
                                              {"uI", {kInfinite}, false},
                                              {"uU", {4294967295.}, true},
                                              {"uU", {0}, true},
                                              {"uU", {-1}, false},
                                              {"uU", {4294967296.}, false},
                                              {"uF", {3.4028234e38}, true},
                                              {"uF", {-3.4028234e38}, true},
                                              {"uF", {3.5e38}, false},
                                              {"uF", {-1e300}, false},
                                              {"uD", {1e300}, true},
                                              {"uIV", {1, 3e9}, false},
                                              {"uUV", {1, 2, -1}, false},
                                              {"uFV", {1e39, 1}, false},
                                              {"uM", {1, 0, 0, 1e39}, false},
                                              {"uA", {1, 2, 3, 2147483648.}, false},
                                              {"uA[3]", {2147483648.}, false},
                                              {"uB", {2}, false},
                                              {"near", {1e39}, false},
                                              {"near", {20}, true}}) {
        const Result<void> set = scene->set(each.name, each.numbers);
        EXPECT_EQ(static_cast<bool>(set), each.isTaken) << each.name << " " << each.numbers.back();
        if (each.isTaken) continue;
        ASSERT_EQ(set.diagnostics().size(), 1U);
        EXPECT_EQ(set.diagnostics().front().id, "library-E03");
        std::string text;
        for (const double number : each.numbers) text += fmt::format("{:.0f} ", number);
        const Result<void> asText = scene->set(each.name, text);
        EXPECT_FALSE(asText) << each.name << " " << text;
        EXPECT_EQ(asText.diagnostics().front().id, "library-E03");
        if (std::string(each.name) == "near") continue;
        EXPECT_FALSE(renderer.loadText(kTypes, "types.glib", kTypesShaders,
                                       {.set = {std::string(each.name) + "=" + text}}))
            << each.name << " " << text;
    }
    EXPECT_TRUE(scene->draw());
}

TEST(LibraryValues, OfArraysHaveTheDeclaredLength) {
    Renderer renderer = opened();
    const char* fragment =
        "#version 330\nconst int kMost = 4;\nuniform float uA[4]; uniform vec3 uV[kMost]; uniform mat2 "
        "uM[3];\n"
        "out vec4 color;\nvoid main() { color = vec4(vec3(uA[2] + uV[0].x + uM[1][1].y), 1); }\n";
    Result<Scene> scene = renderer.loadText(
        "WindowSize 4 4\nVertex square.vert\nFragment a.frag\nProgram Arrays uA [0 0 0 0] uV [0 0 0 0 0 0 0 "
        "0 0 0 0 0] "
        "uM [0 0 0 0 0 0 0 0 0 0 0 0]\nQuadXY 0 10\n",
        "arrays.glib", {{"square.vert", kShaders.at("square.vert")}, {"a.frag", fragment}});
    ASSERT_TRUE(scene) << scene.message();
    for (const Value& each : scene->values())
        EXPECT_EQ(each.value.size(), each.name == "uA" ? 4U : 12U) << each.name;
    EXPECT_TRUE(scene->set("uA", {0., 0., .2, 0.}));
    EXPECT_TRUE(scene->set("uA[3]", 5.));
    EXPECT_TRUE(scene->set("uV[0]", {.2, 5., 5.}));
    EXPECT_TRUE(scene->set("uM[1]", {5., 5., 5., .2}));
    const Result<Picture> picture = scene->draw();
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(firstPixel(*picture), (std::vector<int>{153, 153, 153}));
    EXPECT_FALSE(scene->set("uA", {0., 0., .2}));
    EXPECT_PRED2(isIn, scene->set("uA[4]", 1.).message(), "library-E02");
    EXPECT_PRED2(isIn, scene->set("uV[1]", 1.).message(), "'uV[1]' takes 3 numbers, found 1");
}

TEST(LibraryValues, IncludeUniformsThatTheSceneDoesNotSet) {
    Renderer renderer = opened();
    const char* fragment =
        "#version 330\nuniform vec3 uColor; uniform float uUnset; uniform mat2 uTurn[2]; uniform float uOwn "
        "= .5;\n"
        "out vec4 color;\nvoid main() { color = vec4(uColor * uUnset + uTurn[1][1].y + uOwn * 0., 1); }\n";
    const std::string text =
        "WindowSize 4 4\nVertex square.vert\nFragment unset.frag\nProgram Unset uColor {.2 .4 .6}\nQuadXY 0 "
        "10\n"
        "Expect pixel 1 1 [.2 .4 .6] within .01\n";
    Result<Scene> scene = renderer.loadText(
        text, "unset.glib", {{"square.vert", kShaders.at("square.vert")}, {"unset.frag", fragment}});
    ASSERT_TRUE(scene) << scene.message();
    const auto pixel = [&] {
        const Result<Picture> picture = scene->draw();
        EXPECT_TRUE(picture) << picture.message();
        return picture ? firstPixel(*picture) : std::vector<int>();
    };
    const auto valueOf = [&](std::string_view name) {
        for (const Value& each : scene->values())
            if (each.name == name) return each.value;
        return std::vector<double>();
    };
    EXPECT_EQ(pixel(), (std::vector<int>{0, 0, 0}));
    EXPECT_EQ(valueOf("uUnset"), std::vector<double>{0});
    EXPECT_EQ(valueOf("uTurn").size(), 8U);
    EXPECT_FALSE(scene->check().empty());
    ASSERT_TRUE(scene->set("uUnset", 1.));
    EXPECT_EQ(valueOf("uUnset"), std::vector<double>{1});
    EXPECT_EQ(pixel(), (std::vector<int>{51, 102, 153}));
    ASSERT_TRUE(scene->set("Unset.uUnset", .5));
    EXPECT_EQ(pixel(), (std::vector<int>{26, 51, 76}));
    ASSERT_TRUE(scene->set("uUnset", 1));
    EXPECT_TRUE(scene->check().empty());
    ASSERT_TRUE(scene->reload());
    EXPECT_EQ(pixel(), (std::vector<int>{51, 102, 153}));
    EXPECT_FALSE(scene->set("uNothing", 1.));
}

TEST(LibraryValues, IncludeTagsWithSubscripts) {
    Renderer renderer = opened();
    const char* text =
        "WindowSize 4 4\nFragment inline\n#version 330\nstruct S { vec3 c; float w; };\n"
        "uniform S lights[2]; uniform vec3 cs[3]; out vec4 color;\n"
        "void main() { color = vec4(lights[1].c * lights[1].w + cs[0] + cs[1], 1.); }\n"
        "EndFragment\nLet half .5\nProgram P lights[1].w <0 .5 1> lights[1].c [.4 0 0] "
        "cs [(half * 0) .2 0 0 0 0 0 0 0] cs[1] [0 0 .6]\nFill window with P\n";
    Result<Scene> scene = renderer.loadText(text, "tags.glib");
    ASSERT_TRUE(scene) << scene.message();
    const auto pixel = [&] {
        const Result<Picture> picture = scene->draw();
        EXPECT_TRUE(picture) << picture.message();
        return picture ? firstPixel(*picture) : std::vector<int>();
    };
    EXPECT_EQ(pixel(), (std::vector<int>{51, 51, 153})) << "an element comes after the whole";
    ASSERT_TRUE(scene->set("lights[1].w", 1.));
    ASSERT_TRUE(scene->set("lights[1].c", {.2, .4, 0.}));
    EXPECT_EQ(pixel(), (std::vector<int>{51, 153, 153}));
    std::set<std::string> names;
    for (const Value& each : scene->values()) names.insert(each.name);
    EXPECT_TRUE(names.contains("lights[1].w") && names.contains("lights[1].c"));
}

TEST(LibraryValues, IncludeMembersOfBlocksThatTheSceneDoesNotSet) {
    Renderer renderer = opened();
    // The second block is in a buffer, which has its values.
    const char* text =
        "WindowSize 4 4\nBuffer held float 4 [.2 .2 .2 .2]\nFragment inline\n#version 330\n"
        "uniform Free { vec4 uColor; float uLevels[3]; } free; uniform Held { vec4 uHeld; };\n"
        "out vec4 color; in vec2 vST;\n"
        "void main() { color = free.uColor + vec4(free.uLevels[1]) + uHeld; }\nEndFragment\n"
        "Program Blocks Held held\nFill window with Blocks\n";
    Result<Scene> scene = renderer.loadText(text, "blocks.glib");
    ASSERT_TRUE(scene) << scene.message();
    std::set<std::string> names;
    for (const Value& each : scene->values()) names.insert(each.name);
    EXPECT_EQ(names, (std::set<std::string>{"Free.uColor", "Free.uLevels"}));
    ASSERT_TRUE(scene->set("Free.uColor", {.4, 0., 0., 0.})) << scene->diagnostics().size();
    ASSERT_TRUE(scene->set("Free.uLevels", {0., .2, 0.}));
    const Result<Picture> picture = scene->draw();
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(firstPixel(*picture), (std::vector<int>{204, 102, 102}));
}

TEST(LibraryValues, OfRenderAreTakenOrRefused) {
    Renderer renderer = opened();
    const fs::path scene = kScenes / "start/teapot.glib";
    EXPECT_TRUE(renderer.render(scene, {.width = 16, .height = 12, .set = {"uShininess=5"}}));
    for (const char* each : {"uNope=3", "Nobody:uShininess=3", "uShininess=1,2", "uGlazeColor=1,2"}) {
        const Result<Picture> picture = renderer.render(scene, {.width = 16, .height = 12, .set = {each}});
        EXPECT_FALSE(picture) << each;
        ASSERT_FALSE(picture.diagnostics().empty());
        EXPECT_EQ(picture.diagnostics().front().id, "library-E01") << picture.message();
    }
}

TEST(LibraryScene, ThatWasMovedFromAnswersWithAnError) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(scene) << scene.message();
    Scene taken = std::move(*scene);
    for (const std::string& each :
         {scene->draw().message(), scene->set("uLevel", 1.).message(), scene->set("uLevel", "1").message(),
          scene->target("window").message(), scene->buffer("all").message(), scene->reload().message(),
          toString(scene->check()), toString(scene->problems()), toString(scene->diagnostics())})
        EXPECT_PRED2(isIn, each, "library-E05");
    EXPECT_TRUE(scene->values().empty());
    EXPECT_TRUE(scene->files().empty());
    EXPECT_TRUE(scene->stats().empty());
    EXPECT_TRUE(taken.draw());
    *scene = std::move(taken);
    EXPECT_TRUE(scene->draw());
    Renderer other = std::move(renderer);
    // NOLINTBEGIN(bugprone-use-after-move): it answers with an error
    for (const std::string& each : {renderer.render("a.glib").message(), renderer.load("a.glib").message(),
                                    renderer.loadText(kSquare, "square.glib", kShaders).message()})
        EXPECT_PRED2(isIn, each, "library-E05");
    // NOLINTEND(bugprone-use-after-move)
    EXPECT_TRUE(other.loadText(kSquare, "square.glib", kShaders));
}

TEST(LibraryScene, IsReadAgainAfterAnotherFolderIsTheCurrentOne) {
    const fs::path before = fs::current_path();
    const fs::path folder = fs::temp_directory_path() / ("glibra_folder_" + std::to_string(::getpid()));
    fs::create_directories(folder / "inside");
    std::ofstream(folder / "a.glib") << kSquare << "Expect pixel 1 1 [.2 .4 .6] within .01\n";
    for (const auto& [name, text] : kShaders) std::ofstream(folder / name) << text;
    fs::current_path(folder);
    {
        Renderer renderer = opened();
        Result<Scene> scene = renderer.load("a.glib");
        Result<Scene> inMemory = renderer.loadText(kSquare, "b.glib", kShaders);
        ASSERT_TRUE(scene && inMemory) << scene.message();
        fs::current_path(folder / "inside");
        EXPECT_TRUE(scene->check().empty()) << toString(scene->check());
        for (Scene* each : {&*scene, &*inMemory}) {
            const Result<void> read = each->reload();
            EXPECT_TRUE(read) << read.message();
            EXPECT_TRUE(each->draw());
        }
    }
    fs::current_path(before);
    fs::remove_all(folder);
}

TEST(LibraryScene, RefusesViewsThatAreNotFinite) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(scene) << scene.message();
    const double bad = std::numeric_limits<double>::quiet_NaN();
    std::vector<ViewState> wrong(5);
    wrong[0].scene[3] = bad;
    wrong[1].eye[0] = std::numeric_limits<double>::infinity();
    wrong[2].texture[15] = bad;
    wrong[3].background = std::array<double, 4>{0, bad, 0, 1};
    wrong[4].objects.emplace_back(6, Matrix{bad});
    for (const ViewState& each : wrong) {
        EXPECT_PRED2(isIn, scene->draw({.view = each}).message(), "library-E01");
        EXPECT_PRED2(isIn, renderer.render(kScenes / "start/teapot.glib", {.viewState = each}).message(),
                     "library-E01");
    }
}

/// The picture after changes of n is that of a scene that begins with its last value.
void followsItsSizes(const std::string& declarations) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText("WindowSize 16 16\nLet n <1 4 64>\n" + declarations);
    ASSERT_TRUE(scene) << scene.message();
    for (const int n : {4, 9, 2, 64, 4}) {
        ASSERT_TRUE(scene->set("n", n));
        const Result<Picture> picture = scene->draw();
        ASSERT_TRUE(picture) << picture.message();
        Result<Scene> other =
            renderer.loadText("WindowSize 16 16\nLet n <1 " + std::to_string(n) + " 64>\n" + declarations);
        ASSERT_TRUE(other) << other.message();
        const Result<Picture> expected = other->draw();
        ASSERT_TRUE(expected) << expected.message();
        EXPECT_EQ(picture->data, expected->data) << n;
    }
}

constexpr const char* kShowLength =
    "Fragment inline\n#version 430\nlayout(std430) readonly buffer b { float v[]; };\nout vec4 c;\n"
    "void main() { c = vec4(float(v.length()) / 64., v[v.length() - 1] / 64., 0, 1); }\nEndFragment\n"
    "Program Show\nFill window with Show\n";

TEST(LibraryValues, ChangeTheSizesOfBuffers) {
    followsItsSizes(std::string("Buffer b float (n) (i + 1)\n") + kShowLength);
    followsItsSizes(
        std::string("Buffer b float (n)\nCompute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
                    "layout(std430) buffer b { float v[]; };\n"
                    "void main() { v[gl_GlobalInvocationID.x] += 7.; }\nEndCompute\nProgram Add\n"
                    "Once\nDispatch Add (n)\nEndOnce\n") +
        kShowLength);
}

TEST(LibraryValues, ChangeTheSizesOfTargets) {
    followsItsSizes(
        "Texture2D t (n) (n) rgba8 nearest\nPass t clear {.5 .25 0}\nEndPass\nFragment inline\n#version 330\n"
        "uniform sampler2D t; in vec2 vST; out vec4 c;\n"
        "void main() { c = texture(t, vST) + vec4(0, 0, float(textureSize(t, 0).x) / 64., 1); }\n"
        "EndFragment\nProgram Show\nFill window with Show\n");
}

}  // namespace
}  // namespace glibra
