// The C++ library as a program uses it: scenes that stay loaded.

#include <glibra/glibra.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "../suite/option_samples.h"
#include "support.h"

namespace glibra {
namespace {

using tests::firstPixel;
using tests::isIn;
using tests::kScenes;
using tests::kShaders;
using tests::kSquare;
using tests::opened;

/// True under the address sanitizer, which keeps memory after it was freed.
#if defined(__has_feature)
constexpr bool kKeepsWhatIsFreed = __has_feature(address_sanitizer);
#else
constexpr bool kKeepsWhatIsFreed = false;
#endif

namespace fs = std::filesystem;

TEST(LibraryScene, DrawsWhatRenderDraws) {
    Renderer renderer = opened();
    for (const char* each : {"start/teapot.glib", "modern/life.glib", "modern/shadow_map.glib",
                             "geometry/explosion.glib", "texture/texture_types.glib", "noise/marble.glib"}) {
        const fs::path path = kScenes / each;
        if (!fs::exists(path)) continue;
        Result<Scene> scene = renderer.load(path);
        ASSERT_TRUE(scene) << each << "\n" << scene.message();
        for (const double time : {0., .5, 2.}) {
            RenderOptions options;
            options.width = 96;
            options.height = 72;
            options.time = time;
            const Result<Picture> alone = renderer.render(path, options);
            const Result<Picture> again = scene->draw({.width = 96, .height = 72, .time = time});
            ASSERT_TRUE(alone) << alone.message();
            ASSERT_TRUE(again) << again.message();
            EXPECT_TRUE(alone->data == again->data) << each << " at " << time;
        }
    }
}

TEST(LibraryScene, DrawsWithTheValuesThatAreSet) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(scene) << scene.message();
    const auto drawn = [&] {
        const Result<Picture> picture = scene->draw();
        EXPECT_TRUE(picture) << picture.message();
        return picture ? firstPixel(*picture) : std::vector<int>();
    };
    EXPECT_EQ(drawn(), (std::vector<int>{51, 102, 153}));
    EXPECT_TRUE(scene->set("uLevel", 2.));
    EXPECT_EQ(drawn(), (std::vector<int>{102, 204, 255}));
    EXPECT_TRUE(scene->set("uLevel", 1));
    EXPECT_TRUE(scene->set("uColor", {1., 0., .2}));
    EXPECT_EQ(drawn(), (std::vector<int>{255, 0, 51}));
    EXPECT_TRUE(scene->set("uOn", false));
    EXPECT_EQ(drawn(), (std::vector<int>{255, 255, 255}));
    EXPECT_TRUE(scene->set("uOn", "true"));
    EXPECT_TRUE(scene->set("Square.uColor", "0 1 0"));
    EXPECT_EQ(drawn(), (std::vector<int>{0, 255, 0}));
    for (const Value& each : scene->values())
        if (each.name == "uColor") {
            EXPECT_EQ(each.value, (std::vector<double>{0, 1, 0}));
            EXPECT_EQ(each.initial, (std::vector<double>{.2, .4, .6}));
            EXPECT_EQ(each.type, "vec3");
            EXPECT_EQ(each.program, "Square");
        }
    // A reload keeps them.
    EXPECT_TRUE(scene->reload());
    EXPECT_EQ(drawn(), (std::vector<int>{0, 255, 0}));
}

TEST(LibraryScene, RefusesWrongValuesWithTheReason) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(scene) << scene.message();
    EXPECT_PRED2(isIn, scene->set("uLevle", 1.).message(), "did you mean 'uLevel'?");
    EXPECT_PRED2(isIn, scene->set("uColor", 1.).message(), "'uColor' takes 3 numbers, found 1");
    EXPECT_PRED2(isIn, scene->set("uCount", {1., 1.5, 2.}).message(), "whole numbers");
    EXPECT_PRED2(isIn, scene->set("uOn", 3).message(), "true (1) or false (0)");
    EXPECT_PRED2(isIn, scene->set("uLevel", std::nan("")).message(), "finite");
    EXPECT_PRED2(isIn, scene->set("uLevel", "many").message(), "expected numbers");
    EXPECT_FALSE(scene->set("", 1.));
    EXPECT_FALSE(scene->set("uLevel", std::span<const double>()));
    const Result<Picture> picture = scene->draw();
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(firstPixel(*picture), (std::vector<int>{51, 102, 153}));
}

TEST(LibraryScene, RefusesWrongOptions) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(scene) << scene.message();
    const double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const DrawOptions& each :
         {DrawOptions{.width = -5}, DrawOptions{.height = 70'000}, DrawOptions{.time = kNan},
          DrawOptions{.samples = -1}, DrawOptions{.time = std::numeric_limits<double>::infinity()},
          DrawOptions{.samples = 1000}}) {
        const Result<Picture> picture = scene->draw(each);
        EXPECT_FALSE(picture);
        ASSERT_EQ(picture.diagnostics().size(), 1U);
        EXPECT_EQ(picture.diagnostics().front().id, "library-E01");
    }
    RenderOptions wrong;
    wrong.width = -5;
    EXPECT_EQ(renderer.render(kScenes / "start/teapot.glib", wrong).diagnostics().front().id, "library-E01");
    EXPECT_FALSE(renderer.load(kScenes / "start/teapot.glib", wrong));
}

TEST(LibraryScene, RefusesOptionsThatItWouldNotKeep) {
    Renderer renderer = opened();
    std::vector<RenderOptions> wrong(9);
    wrong[0].maxError = .5;
    wrong[1].axes = true;
    wrong[2].labels = LabelCorner::topLeft;
    wrong[3].incomplete = true;
    wrong[4].checkNan = true;
    wrong[5].time = 1;
    wrong[6].width = 20;
    wrong[7].viewState.projection = ProjectionMode::orthographic;
    wrong[8].wantedObjects = {"shadow"};
    for (const RenderOptions& each : wrong) {
        const Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders, each);
        EXPECT_FALSE(scene);
        ASSERT_EQ(scene.diagnostics().size(), 1U);
        EXPECT_EQ(scene.diagnostics().front().id, "library-E01");
    }
}

TEST(LibraryScene, DrawsTheAxesThatAPictureOfRenderHas) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.load(kScenes / "start/teapot.glib");
    ASSERT_TRUE(scene) << scene.message();
    const Result<Picture> plain = scene->draw({.width = 64, .height = 48});
    const Result<Picture> drawn = scene->draw({.width = 64, .height = 48, .axes = true});
    RenderOptions options;
    options.width = 64;
    options.height = 48;
    options.axes = true;
    const Result<Picture> rendered = renderer.render(kScenes / "start/teapot.glib", options);
    ASSERT_TRUE(plain && drawn && rendered);
    EXPECT_NE(drawn->data, plain->data);
    EXPECT_EQ(drawn->data, rendered->data);
    EXPECT_EQ(scene->draw({.width = 64, .height = 48})->data, plain->data) << "they do not stay";
}

TEST(LibraryScene, KeepsOrRefusesEveryOptionOfPictures) {
    Renderer renderer = opened();
    const std::set<std::string_view> kept{"steps",   "set",     "eye",     "strict", "no-shim",
                                          "no-skip", "library", "timeout", "memory"};
    for (const suite::OptionRow& row : suite::optionTable()) {
        suite::Shot shot;
        suite::test::setSample(row, shot);
        const Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders, shot.options);
        const bool isRefused = !scene && scene.diagnostics().front().id == "library-E01";
        EXPECT_EQ(isRefused, !kept.contains(row.name)) << row.name;
    }
    for (const std::string_view each : kept) EXPECT_TRUE(suite::findOption(each)) << each;
    RenderOptions several;
    several.axes = several.checkNan = several.alpha = true;
    EXPECT_EQ(renderer.loadText(kSquare, "square.glib", kShaders, several).diagnostics().size(), 3U);
}

TEST(LibraryScene, IsAsItWasAfterAFaultyReload) {
    const fs::path folder = fs::temp_directory_path() / ("glibra_reload_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const auto write = [&](const std::string& text) { std::ofstream(folder / "a.glib") << text; };
    for (const auto& [name, text] : kShaders) std::ofstream(folder / name) << text;
    write(kSquare);
    Renderer renderer = opened();
    Result<Scene> scene = renderer.load(folder / "a.glib");
    ASSERT_TRUE(scene) << scene.message();
    ASSERT_TRUE(scene->set("uColor", {1., 0., .2}));
    ASSERT_TRUE(scene->draw());
    write(std::string(kSquare) + "Spere 2\n");
    EXPECT_FALSE(scene->reload());
    EXPECT_TRUE(scene->target("window"));
    const Result<Picture> before = scene->draw();
    ASSERT_TRUE(before) << before.message();
    EXPECT_EQ(firstPixel(*before), (std::vector<int>{255, 0, 51}));
    EXPECT_TRUE(scene->diagnostics().empty());
    std::ofstream(folder / "square.frag") << "#version 330\nbroken\n";
    write(kSquare);
    EXPECT_FALSE(scene->reload());
    EXPECT_TRUE(scene->draw());
    std::ofstream(folder / "square.frag") << kShaders.at("square.frag");
    write(std::string("# deeper\n") + kSquare);
    ASSERT_TRUE(scene->reload());
    const Result<Picture> after = scene->draw();
    ASSERT_TRUE(after) << after.message();
    EXPECT_EQ(firstPixel(*after), (std::vector<int>{255, 0, 51}));
    fs::remove_all(folder);
}

TEST(LibraryScene, OfAWrongTextIsAnErrorWithItsPlace) {
    Renderer renderer = opened();
    const Result<Scene> scene = renderer.loadText("Sphere 1\nSpere 2\n", "mine.glib");
    EXPECT_FALSE(scene);
    EXPECT_PRED2(isIn, scene.message(), "mine.glib:2:1: error");
    EXPECT_FALSE(renderer.load("no/such.glib"));
    // The renderer goes on.
    EXPECT_TRUE(renderer.loadText(kSquare, "square.glib", kShaders));
}

TEST(LibraryScene, GivesTheContentOfTexturesAndBuffers) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(
        "Texture2D small 4 2 rgba32f\n"
        "Buffer numbers vec4 3 (vec4(i, 2*i, 3, 4))\n"
        "Compute fill.comp\nProgram Fill\nDispatch Fill 1 1 1\n"
        "Pass small clear {.25 .5 2}\nEndPass\n"
        "Pass window clear {.5 .5 .5}\n"
        "Vertex square.vert\nFragment shown.frag\nProgram Shown\nQuadXY 0 10\nEndPass\n",
        "content.glib",
        {kShaders.begin()->first == "square.frag" ? *kShaders.rbegin() : *kShaders.begin(),
         {"shown.frag",
          "#version 430\nuniform sampler2D small; layout(std430) buffer numbers { vec4 all[]; };\n"
          "out vec4 color;\nvoid main() { color = texture(small, vec2(.5)) + all[2] * 0.; }\n"},
         {"fill.comp",
          "#version 430\nlayout(local_size_x = 1) in;\nlayout(std430) buffer numbers { vec4 all[]; };\n"
          "void main() { all[2] = all[0] + all[1]; }\n"}});
    ASSERT_TRUE(scene) << scene.message();
    EXPECT_FALSE(scene->target("small"));  // nothing is drawn yet
    ASSERT_TRUE(scene->draw({.width = 4, .height = 4}));
    const Result<Picture> small = scene->target("small");
    ASSERT_TRUE(small) << small.message();
    ASSERT_EQ(small->width, 4);
    ASSERT_EQ(small->height, 2);
    ASSERT_TRUE(small->isFloat);
    float green = 0;
    std::memcpy(&green, small->data.data() + sizeof green, sizeof green);
    EXPECT_EQ(green, .5F);
    const Result<Picture> window = scene->target("window");
    ASSERT_TRUE(window) << window.message();
    EXPECT_TRUE(window->isFloat);
    EXPECT_PRED2(isIn, scene->target("smal").message(), "did you mean 'small'?");
    EXPECT_PRED2(isIn, scene->target("small.layer(1)").message(), "'small' has 1 layer");
    for (const char* each : {"smal", "", "small.layer(1)", "small.level(1)", "small.face(2)", "small.prev",
                             "small.side(0)", "small.level(x)"}) {
        const Result<Picture> none = scene->target(each);
        ASSERT_EQ(none.diagnostics().size(), 1U) << each;
        EXPECT_EQ(none.diagnostics().front().id, "library-E02") << each;
        EXPECT_EQ(none.diagnostics().front().place.file, "content.glib") << each;
    }

    const Result<BufferContent> numbers = scene->buffer("numbers");
    ASSERT_TRUE(numbers) << numbers.message();
    EXPECT_EQ(numbers->elements, 3U);
    EXPECT_EQ(numbers->stride, 16U);
    const auto sum = numbers->element<std::array<float, 4>>(2);
    EXPECT_EQ(sum, (std::array<float, 4>{1, 2, 6, 8}));
    EXPECT_PRED2(isIn, scene->buffer("number").message(), "did you mean 'numbers'?");
}

TEST(LibraryScene, AnswersItsChecks) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(std::string(kSquare) + "Expect pixel 1 1 [.2 .4 .6] within .01\n",
                                            "square.glib", kShaders);
    ASSERT_TRUE(scene) << scene.message();
    EXPECT_TRUE(scene->check().empty());
    ASSERT_TRUE(scene->set("uLevel", 2.));
    const Diagnostics wrong = scene->check();
    ASSERT_EQ(wrong.size(), 1U);
    EXPECT_EQ(wrong.front().id, "check-E01");
}

TEST(LibraryScene, ComparesAndSavesPictures) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.load(kScenes / "start/teapot.glib");
    ASSERT_TRUE(scene) << scene.message();
    const Result<Picture> one = scene->draw({.width = 64, .height = 48});
    const Result<Picture> other = scene->draw({.width = 64, .height = 48, .time = 0, .alpha = true});
    ASSERT_TRUE(one && other);
    EXPECT_EQ(other->components, 4);
    EXPECT_TRUE(compare(*one, *other).same);
    ASSERT_TRUE(scene->set("uGlazeColor", {1., 0., 0.}));
    const Result<Picture> red = scene->draw({.width = 64, .height = 48});
    ASSERT_TRUE(red);
    const Comparison found = compare(*red, *one);
    EXPECT_FALSE(found.same);
    EXPECT_GT(found.differingPixels, 100U);
    const fs::path file = fs::temp_directory_path() / "glibra_library_test.png";
    ASSERT_TRUE(one->save(file));
    EXPECT_TRUE(compare(*one, file).same);
    EXPECT_TRUE(compare(file, file).same);
    fs::remove(file);
    const Comparison missing = compare(*one, file);
    EXPECT_FALSE(missing.same);
    EXPECT_FALSE(missing.reason.empty());
    EXPECT_FALSE(one->save(fs::path("no/such/folder") / "a.png"));
    EXPECT_FALSE(Picture().save(file));
}

TEST(LibraryScene, DoesNotGrowFromDrawToDraw) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(scene) << scene.message();
    const auto resident = [] {
        std::ifstream status("/proc/self/statm");
        long all = 0, here = 0;
        status >> all >> here;
        return here;  // pages
    };
    const auto draws = [&](int count) {
        for (int i = 0; i < count; ++i) {
            ASSERT_TRUE(scene->set("uLevel", i % 100 / 50.));
            ASSERT_TRUE(scene->draw({.time = i / 60.}));
        }
    };
    draws(500);
    const long before = resident();
    draws(3000);
    EXPECT_TRUE(kKeepsWhatIsFreed || resident() - before < 256) << resident() - before << " pages of 4 kB";
}

TEST(LibraryResultDeathTest, WithoutAValueEndsWithItsMessage) {
    const Result<int> bad = diagnose("library-E02", "the scene has no value 'x'");
    EXPECT_DEATH(static_cast<void>(*bad), "the scene has no value 'x'");
}

}  // namespace
}  // namespace glibra
