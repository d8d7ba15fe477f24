// The C++ library as a program uses it: scenes that stay loaded.

#include <glibra/glibra.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "../suite/option_samples.h"

namespace glibra {
namespace {

/// The address sanitizer does.
#if defined(__has_feature)
constexpr bool kKeepsWhatIsFreed = __has_feature(address_sanitizer);
#else
constexpr bool kKeepsWhatIsFreed = false;
#endif

namespace fs = std::filesystem;

const fs::path kScenes = GLIBRA_SOURCE_DIR "/glib";

Renderer opened() {
    Result<Renderer> renderer = Renderer::open();
    EXPECT_TRUE(renderer) << renderer.message();
    return std::move(*renderer);
}

bool isIn(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

/// A square that fills the picture with a colour.
constexpr const char* kSquare =
    "WindowSize 8 6\nBackground 0 0 0\nVertex square.vert\nFragment square.frag\n"
    "Program Square uColor {.2 .4 .6} uLevel <0 1 2> uOn <true> uCount [2 1 1]\nQuadXY 0 10\n";
const std::map<std::string, std::string> kShaders{
    {"square.vert",
     "#version 330\nin vec4 aVertex;\nvoid main() { gl_Position = vec4(aVertex.xy, 0, 1); }\n"},
    {"square.frag",
     "#version 330\nuniform vec3 uColor; uniform float uLevel; uniform bool uOn; uniform ivec3 uCount;\n"
     "out vec4 color;\nvoid main() { color = vec4(uOn ? uLevel * uColor * float(uCount.y) : vec3(1), 1); "
     "}\n"}};

std::vector<int> firstPixel(const Picture& picture) {
    std::vector<int> values;
    for (int i = 0; i < picture.components; ++i)
        values.push_back(std::to_integer<int>(picture.data[static_cast<std::size_t>(i)]));
    return values;
}

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

TEST(LibraryRenderer, GivesEveryErrorAnId) {
    Renderer renderer = opened();
    std::vector<RenderOptions> wrong(4);
    wrong[0].set = {"uShininess"};
    wrong[1].set = {"uShininess=bright"};
    wrong[2].set = {"uShininess="};
    wrong[3].wantedObjects = {"nope"};
    for (const RenderOptions& each : wrong) {
        const fs::path scene = kScenes / "start/teapot.glib";
        const Result<Picture> picture = renderer.render(scene, each);
        EXPECT_FALSE(picture);
        ASSERT_FALSE(picture.diagnostics().empty());
        EXPECT_EQ(picture.diagnostics().back().id, "library-E01") << picture.message();
        EXPECT_EQ(picture.diagnostics().back().place.file, scene.string());
    }
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

TEST(LibraryRenderer, OfAnotherThreadIsRefused) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(scene) << scene.message();
    std::string ofDraw, ofSet, ofLoad, ofRender;
    std::thread([&] {
        ofDraw = scene->draw().message();
        ofSet = scene->set("uLevel", 1.).message();
        ofLoad = renderer.loadText(kSquare, "square.glib", kShaders).message();
        ofRender = renderer.render("a.glib").message();
    }).join();
    for (const std::string& each : {ofDraw, ofSet, ofLoad, ofRender})
        EXPECT_PRED2(isIn, each, "another thread");
    EXPECT_TRUE(scene->draw());
}

TEST(LibraryRenderer, TwoOnOneThreadDrawEachTheirOwn) {
    Renderer one = opened();
    Result<Scene> first = one.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(first) << first.message();
    Renderer two = opened();
    Result<Scene> second = two.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(second) << second.message();
    ASSERT_TRUE(second->set("uColor", {1., 0., .2}));
    for (int round = 0; round < 3; ++round) {
        const Result<Picture> ofFirst = first->draw();
        const Result<Picture> ofSecond = second->draw();
        ASSERT_TRUE(ofFirst && ofSecond);
        EXPECT_EQ(firstPixel(*ofFirst), (std::vector<int>{51, 102, 153}));
        EXPECT_EQ(firstPixel(*ofSecond), (std::vector<int>{255, 0, 51}));
        EXPECT_TRUE(first->target("window"));
        EXPECT_TRUE(one.render(kScenes / "start/teapot.glib", {.width = 16, .height = 12}));
        EXPECT_TRUE(second->reload());
    }
    {
        // The end of a renderer and of its scene leaves the other's alone.
        const Scene gone = std::move(*second);
        const Renderer last = std::move(two);
    }
    const Result<Picture> still = first->draw();
    ASSERT_TRUE(still) << still.message();
    EXPECT_EQ(firstPixel(*still), (std::vector<int>{51, 102, 153}));
}

TEST(LibraryRenderer, OfAnotherDriverOnAnotherThreadIsRefused) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(scene) << scene.message();
    std::string message;
    bool isOpen = false;
    std::thread([&] {
        const Result<Renderer> other = Renderer::open(Driver::osmesa);
        isOpen = static_cast<bool>(other);
        message = other ? "" : other.message();
    }).join();
    if (!isOpen) {
        EXPECT_PRED2(isIn, message, "gpu-E01");
    }
    const Result<Picture> picture = scene->draw();
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(firstPixel(*picture), (std::vector<int>{51, 102, 153}));
}

TEST(LibraryRenderer, MayEndOnAnyThread) {
    {
        Renderer renderer = opened();
        Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders);
        Result<Scene> other = renderer.loadText(kSquare, "square.glib", kShaders);
        ASSERT_TRUE(scene && other);
        ASSERT_TRUE(scene->draw());
        std::thread([gone = std::move(*scene)]() mutable { const Scene last = std::move(gone); }).join();
        const Result<Picture> picture = other->draw();
        ASSERT_TRUE(picture) << picture.message();
        EXPECT_EQ(firstPixel(*picture), (std::vector<int>{51, 102, 153}));
        std::thread([gone = std::move(*other), last = std::move(renderer)]() mutable {
            const Scene ended = std::move(gone);
            const Renderer end = std::move(last);
        }).join();
    }
    // From the thread that opened it, after that has ended.
    std::unique_ptr<Scene> left;
    std::thread([&] {
        Result<Renderer> renderer = Renderer::open();
        Result<Scene> scene = renderer->loadText(kSquare, "square.glib", kShaders);
        if (scene && scene->draw()) left = std::make_unique<Scene>(std::move(*scene));
    }).join();
    ASSERT_TRUE(left);
    Renderer here = opened();
    Result<Scene> mine = here.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(mine);
    left.reset();
    const Result<Picture> picture = mine->draw();
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(firstPixel(*picture), (std::vector<int>{51, 102, 153}));
}

/// Scenes with a built-in shape, noise textures, pictures, passes and a simulation; the second thread draws
/// them in the opposite order, so that each reads while the other draws.
TEST(LibraryRenderer, TwoOnTwoThreadsDrawEqualPixels) {
    const std::vector<fs::path> scenes{"start/teapot.glib", "noise/marble.glib",
                                       "texture/reflect_refract.glib", "modern/bloom.glib",
                                       "modern/cloth.glib"};
    std::vector<std::vector<std::byte>> pictures[2];
    std::string problems[2];
    std::vector<std::thread> threads;
    for (std::size_t thread = 0; thread < 2; ++thread)
        threads.emplace_back([&, thread] {
            pictures[thread].resize(scenes.size());
            Result<Renderer> renderer = Renderer::open();
            if (!renderer) return void(problems[thread] = renderer.message());
            for (std::size_t i = 0; i < scenes.size(); ++i) {
                const std::size_t which = thread == 0 ? i : scenes.size() - 1 - i;
                Result<Scene> scene = renderer->load(kScenes / scenes[which]);
                if (!scene) return void(problems[thread] = scene.message());
                for (int frame = 0; frame < 10; ++frame) {
                    Result<Picture> picture = scene->draw({.width = 64, .height = 48, .time = frame / 30.});
                    if (!picture) return void(problems[thread] = picture.message());
                    pictures[thread][which] = std::move(picture->data);
                }
            }
        });
    for (std::thread& each : threads) each.join();
    EXPECT_EQ(problems[0] + problems[1], "");
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        EXPECT_FALSE(pictures[0][i].empty()) << scenes[i];
        EXPECT_TRUE(pictures[0][i] == pictures[1][i]) << scenes[i];
    }
}

TEST(LibraryRenderer, AdoptsTheCallersContext) {
    EXPECT_FALSE(Renderer::open(CurrentContext{}));
    const Renderer host = opened();  // whose context is current now
    Result<Renderer> guest = Renderer::open(Renderer::current());
    ASSERT_TRUE(guest) << guest.message();
    Result<Scene> scene = guest->loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(scene) << scene.message();
    const Result<Picture> picture = scene->draw();
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(firstPixel(*picture), (std::vector<int>{51, 102, 153}));
}

TEST(LibraryRenderer, MayEndBeforeItsScenes) {
    std::unique_ptr<Scene> scene;
    {
        Renderer renderer = opened();
        Result<Scene> loaded = renderer.loadText(kSquare, "square.glib", kShaders);
        ASSERT_TRUE(loaded) << loaded.message();
        scene = std::make_unique<Scene>(std::move(*loaded));
    }
    EXPECT_TRUE(scene->draw());
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
