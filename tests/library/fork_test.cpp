// What a process inherits when a program that draws forks: errors in place of calls that wait for ever.

#include <glibra/glibra.h>
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "../forked_process.h"
#include "support.h"

namespace glibra {
namespace {

using tests::firstPixel;
using tests::inChild;
using tests::isIn;
using tests::kScenes;
using tests::kShaders;
using tests::kSquare;
using tests::opened;

TEST(LibraryFork, EveryCallOfTheChildIsRefused) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(scene) << scene.message();
    for (const bool isDrawn : {false, true}) {
        if (isDrawn) {
            ASSERT_TRUE(scene->draw());
        }
        const std::function<std::string()> calls[] = {
            [&] { return scene->draw().message(); },
            [&] { return scene->set("uLevel", 1.).message(); },
            [&] { return scene->set("uLevel", "1").message(); },
            [&] { return scene->target("window").message(); },
            [&] { return scene->buffer("all").message(); },
            [&] { return scene->write("all", std::vector<float>(4)).message(); },
            [&] { return scene->reload().message(); },
            [&] { return toString(scene->check()); },
            [&] { return toString(scene->problems()); },
            [&] { return renderer.load(kScenes / "start/teapot.glib").message(); },
            [&] { return renderer.render(kScenes / "start/teapot.glib").message(); },
            [&] { return Renderer::open().message(); },
            [&] { return Renderer::open(Driver::osmesa).message(); },
            [&] { return Renderer::open(Renderer::current()).message(); },
            [&] { return inChild([&] { return scene->draw().message(); }); },
        };
        for (const auto& call : calls) {
            const std::string message = inChild(call);
            EXPECT_PRED2(isIn, message, "[gpu-E08]");
            EXPECT_PRED2(isIn, message, "forked");
        }
        EXPECT_EQ(inChild([&] { return std::to_string(scene->values().size()); }), "0");
    }
    const Result<Picture> picture = scene->draw();
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(firstPixel(*picture), (std::vector<int>{51, 102, 153}));
}

TEST(LibraryFork, WhatTheChildInheritsEndsThereAndLivesOnInTheParent) {
    std::optional<Renderer> renderer = opened();
    Result<Scene> scene = renderer->loadText(kSquare, "square.glib", kShaders);
    Result<Scene> other = renderer->loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(scene && other);
    ASSERT_TRUE(scene->draw());
    EXPECT_EQ(inChild([&] {
                  scene.value.reset();
                  renderer.reset();
                  other.value.reset();
                  return std::string("ended");
              }),
              "ended");
    const Result<Picture> picture = scene->draw();
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(firstPixel(*picture), (std::vector<int>{51, 102, 153}));
}

TEST(LibraryFork, PicturesAreComparedAndSavedInTheChild) {
    Renderer renderer = opened();
    Result<Scene> scene = renderer.loadText(kSquare, "square.glib", kShaders);
    ASSERT_TRUE(scene) << scene.message();
    const Result<Picture> picture = scene->draw();
    ASSERT_TRUE(picture) << picture.message();
    EXPECT_EQ(inChild([&] { return compare(*picture, *picture).reason; }), "equal");
}

}  // namespace
}  // namespace glibra
