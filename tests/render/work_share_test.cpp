#include "render/draw/work_share.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

#include "gpu/context/context.h"
#include "render/draw/frame.h"
#include "render/scene_renderer.h"

namespace glibra::render {
namespace {

namespace fs = std::filesystem;

/// Does rows that take `seconds`, and what each part takes besides.
struct Work {
    std::vector<double> seconds;
    double own = 0;
    std::vector<int> done{};
    double longest = 0;

    int waits = 0;

    int run(double share) {
        done.assign(seconds.size(), 0);
        double unwaited = 0;
        return doInShares(
                   static_cast<int>(seconds.size()), share,
                   [&](int first, int end) {
                       double taken = own;
                       for (int i = first; i < end; ++i) {
                           ++done.at(static_cast<std::size_t>(i));
                           taken += seconds[static_cast<std::size_t>(i)];
                       }
                       longest = std::max(longest, taken);
                       unwaited += taken;
                   },
                   [&] {
                       ++waits;
                       return std::exchange(unwaited, 0);
                   })
            .parts;
    }
};

TEST(WorkShare, DoesEveryRowOnce) {
    for (const std::size_t rows : {1U, 2U, 15U, 16U, 17U, 100U, 127U, 128U, 129U, 1000U, 4096U})
        for (const double each : {0., 1e-9, 1e-3, .05, 1., 100.})
            for (const double own : {0., 1e-4, .01, 5.}) {
                Work work{std::vector<double>(rows, each), own};
                work.run(.1);
                EXPECT_EQ(work.done, std::vector<int>(rows, 1)) << rows << " " << each << " " << own;
            }
}

TEST(WorkShare, NoPartTakesLongWhereRowsAreAlike) {
    for (const double all : {.01, 1., 10., 100., 400.}) {
        Work work{std::vector<double>(1000, all / 1000)};
        work.run(.1);
        EXPECT_LT(work.longest, std::max(.15, all / 100)) << all;
    }
}

TEST(WorkShare, QuickWorkIsHardlyCut) {
    Work work{std::vector<double>(1000, 1e-6)};
    EXPECT_LE(work.run(.1), 7);
    EXPECT_EQ(work.waits, 2) << "for what each part costs, and for the probes";
}

TEST(WorkShare, WorkThatEveryPartRepeatsIsNotMultiplied) {
    Work vertices{std::vector<double>(1000, 1e-7), 1.};
    EXPECT_EQ(vertices.run(.1), 1);
    Work both{std::vector<double>(1000, 1.), .05};
    EXPECT_LT(both.run(.1), 100);
}

/// The window of a scene, drawn whole and in parts.
TEST(WorkShare, PicturesThatAreDrawnInPartsAreTheSame) {
    Result<gpu::Context> context = gpu::openContext();
    ASSERT_TRUE(context);
    int cut = 0;
    for (const char* folder : {"modern", "patterns", "texture", "start"})
        for (const auto& each : fs::directory_iterator(fs::path(GLIBRA_SOURCE_DIR) / "glib" / folder)) {
            if (each.path().extension() != ".glib") continue;
            Stats stats;
            RenderOptions options;
            options.width = options.height = 64;
            Result<SceneRenderer> scene = SceneRenderer::load(*context, each.path(), options, stats);
            if (!scene || scene->remembersFrames() || scene->runsSteps()) continue;
            const Result<image::Image> whole = scene->draw(0, stats);
            Stats ofParts;
            Result<SceneRenderer> other = SceneRenderer::load(*context, each.path(), options, ofParts);
            ASSERT_TRUE(other);
            other->drawer().setTimeShare(.05);  // the first draw of a program is done in parts
            const Result<image::Image> parts = other->draw(0, ofParts);
            ASSERT_EQ(bool(whole), bool(parts)) << each.path();
            EXPECT_TRUE(!whole || whole->data == parts->data) << each.path();
            for (const Stats::Count& count : ofParts.counts) cut += count.name == "parts of draws" ? 1 : 0;
        }
    EXPECT_GT(cut, 3) << "scenes with loops";
}

}  // namespace
}  // namespace glibra::render
