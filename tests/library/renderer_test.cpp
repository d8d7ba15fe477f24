// The C++ library as a program uses it: renderers, their threads and their errors.

#include <glibra/glibra.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <thread>
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

}  // namespace
}  // namespace glibra
