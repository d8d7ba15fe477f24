// Pictures that are not the same each time: a stated tolerance, what is ignored, further accepted pictures,
// days, and what the commands of a report do.

#include <gtest/gtest.h>

#include <filesystem>

#include "folder.h"
#include "image/write.h"
#include "pictures.h"
#include "suite/file/shot_name.h"
#include "suite/file/suite_file.h"
#include "suite/golden/ignored.h"
#include "suite/golden/orphans.h"
#include "suite/results/results.h"
#include "suite/suite.h"
#include "suite_text.h"

namespace glibra::suite {
namespace {

class Noisy : public testing::Test {
  protected:
    Noisy() {
        suite.name = "s";
        suite.file = folder / "s.toml";
        suite.goldens = folder / "goldens";
    }
    Judged decide(const image::Image& first, const image::Image& again, JudgeOptions options = {}) {
        options.results = folder / "results";
        const GoldenStore store = *GoldenStore::open(suite);
        const ShotJudge judge(suite, store, "llvmpipe", "key", options);
        const Attempt attempt = attemptAt(shot, first);
        std::optional<Judged> judged = judge.first(attempt);
        if (!judged) judged = judge.second(attempt, attemptAt(shot, again));
        if (judged->accepted) {
            EXPECT_TRUE(acceptHashes(store.hashFile(), std::vector{*judged->accepted}).empty());
        }
        return *judged;
    }
    ShotResult decide(const image::Image& picture) { return decide(picture, picture).result; }
    ShotResult accept(const image::Image& picture, JudgeOptions options = {}) {
        options.update = true;
        return decide(picture, picture, options).result;
    }

    Folder folder;
    Suite suite;
    Shot shot = shotNamed("a");
};

TEST_F(Noisy, AStatedToleranceIsForTheTwoDrawingsToo) {
    EXPECT_EQ(decide(gradient(), gradient(2), {.update = true}).result.verdict, Verdict::unstable);
    shot.statesTolerance = true;
    EXPECT_EQ(decide(gradient(), gradient(9), {.update = true}).result.verdict, Verdict::unstable);
    EXPECT_FALSE(std::filesystem::exists(folder / "goldens/a.png"));
    shot.tolerance.bias = 3;
    EXPECT_EQ(decide(gradient(), gradient(2), {.update = true}).result.verdict, Verdict::updated);
    EXPECT_EQ(decide(gradient(2)).verdict, Verdict::passed);
    EXPECT_EQ(decide(gradient(40), gradient(41)).result.verdict, Verdict::failed);
}

TEST_F(Noisy, AnUnstableShotHasNoPictureToAcceptAndNamesBothDrawings) {
    const ShotResult result = decide(gradient(), gradient(1)).result;
    EXPECT_EQ(result.verdict, Verdict::unstable);
    EXPECT_EQ(result.accept, "");
    EXPECT_STREQ(titlesOf(result).expected, "second drawing");
    EXPECT_STREQ(titlesOf(result).got, "first drawing");
    EXPECT_STREQ(titlesOf(decide(gradient())).expected, "expected");
}

TEST_F(Noisy, TheAcceptCommandIsOneThatWorks) {
    const std::string file = suite.file.string();
    EXPECT_EQ(decide(gradient()).accept, "glibra test " + file + " --only a --update");
    EXPECT_EQ(decide(oneColor(7)).accept, "glibra test " + file + " --only a --update --force");
    EXPECT_EQ(accept(oneColor(7)).accept, "glibra test " + file + " --only a --update --force");
    suite.goldens = folder / "../elsewhere";
    EXPECT_EQ(decide(gradient()).accept, "glibra test " + file + " --only a --update --allow-outside");
    const GoldenStore store = *GoldenStore::open(suite, folder / "mine");
    const ShotJudge judge(suite, store, "llvmpipe", "key", {.results = folder / "results"});
    EXPECT_EQ(judge.second(attemptAt(shot, gradient()), attemptAt(shot, gradient())).result.accept,
              "glibra test " + file + " --only a --update --goldens " + (folder / "mine").string());
}

TEST_F(Noisy, EachOfSeveralAcceptedPicturesPasses) {
    ASSERT_EQ(accept(gradient()).verdict, Verdict::updated);
    const ShotResult added = accept(gradient(40), {.also = true});
    EXPECT_EQ(added.verdict, Verdict::updated);
    EXPECT_EQ(added.goldenVariant, "also1");
    EXPECT_EQ(added.reason.rfind("golden added", 0), 0U) << added.reason;
    EXPECT_EQ(decide(gradient()).verdict, Verdict::passed);
    const ShotResult other = decide(gradient(40));
    EXPECT_EQ(other.verdict, Verdict::passed);
    EXPECT_EQ(other.goldenVariant, "also1");
    EXPECT_TRUE(other.exact) << "its pixels are in the list";
    EXPECT_EQ(decide(gradient(80)).verdict, Verdict::failed);
    suite.shots = {shot};
    EXPECT_TRUE(orphanGoldens(suite, {}, {}).empty());
    EXPECT_EQ(shotOfVariant("a.also1"), "a");
    EXPECT_EQ(shotOfVariant("a.also12"), "");
}

TEST_F(Noisy, AShotHasTenAcceptedPicturesAtMost) {
    ASSERT_EQ(accept(gradient()).verdict, Verdict::updated);
    for (int i = 1; i <= 9; ++i)
        EXPECT_EQ(accept(gradient(10 * i), {.also = true}).verdict, Verdict::updated) << i;
    const ShotResult full = accept(gradient(100), {.also = true});
    EXPECT_EQ(full.verdict, Verdict::failed);
    EXPECT_EQ(full.diagnostics.back().id, "suite-E31");
}

/// The gradient with a white line of 20 pixels.
image::Image withLine(int x, int y) {
    image::Image image = gradient();
    for (int dx = 0; dx < 20 && x + dx < 32; ++dx)
        for (std::size_t c = 0; c < 3; ++c)
            image.data[static_cast<std::size_t>(y * 32 + x + dx) * 3 + c] = std::byte{255};
    return image;
}

TEST_F(Noisy, AnIgnoredRectangleIsNotComparedAndNothingElseIsLeftOut) {
    shot.tolerance.fraction = 0;
    ASSERT_EQ(accept(gradient()).verdict, Verdict::updated);
    EXPECT_EQ(decide(withLine(10, 5)).verdict, Verdict::failed);
    shot.ignored = {{10, 5, 20, 1, ""}};
    const ShotResult ignored = decide(withLine(10, 5));
    EXPECT_EQ(ignored.verdict, Verdict::passed);
    EXPECT_FALSE(ignored.exact);
    for (const auto& [x, y] : {std::pair{10, 4}, {10, 6}, {9, 5}, {11, 5}})
        EXPECT_EQ(decide(withLine(x, y)).verdict, Verdict::failed) << x << ' ' << y;
    // The two drawings are compared in the same way.
    EXPECT_EQ(decide(withLine(10, 20), withLine(10, 20)).result.verdict, Verdict::failed);
}

TEST_F(Noisy, PixelsThatWereAcceptedUnderAnIgnoredRectangleAreNotAcceptedWithoutIt) {
    shot.tolerance.fraction = 0;
    ASSERT_EQ(accept(gradient()).verdict, Verdict::updated);
    shot.ignored = {{10, 5, 20, 1, ""}};
    EXPECT_EQ(accept(withLine(10, 5)).verdict, Verdict::passed);
    EXPECT_EQ(decide(withLine(10, 5)).verdict, Verdict::passed);
    shot.ignored.clear();
    EXPECT_EQ(decide(withLine(10, 5)).verdict, Verdict::failed);
}

/// Whatever covers the picture, alone or together: nothing passes that is compared with nothing.
TEST_F(Noisy, APictureOfWhichNothingIsComparedFails) {
    ASSERT_EQ(accept(gradient()).verdict, Verdict::updated);
    const std::filesystem::path mask = folder / "mask.png";
    const auto write = [&](const std::function<int(int, int, int)>& value) {
        ASSERT_TRUE(image::writeImage(picture(32, 32, value), mask).empty());
    };
    const auto expectNothing = [&](const char* which) {
        for (const image::Image& drawn : {gradient(), oneColor(7)}) {
            const Judged judged = decide(drawn, drawn);
            EXPECT_EQ(judged.result.verdict, Verdict::failed) << which;
            ASSERT_FALSE(judged.result.diagnostics.empty()) << which;
            EXPECT_EQ(judged.result.diagnostics.back().id, "suite-E21") << which;
            EXPECT_EQ(judged.result.diagnostics.back().place.line, 4) << which;
            EXPECT_TRUE(judged.result.accept.empty()) << which;
        }
        EXPECT_EQ(accept(gradient(40)).verdict, Verdict::failed) << which << ": no golden is made of it";
    };
    const Place place{"s.toml", 4, 1};
    shot.ignored = {{0, 0, 32, 32, "", place}};
    expectNothing("one rectangle");
    shot.ignored = {{0, 0, 32, 20, "", place}, {0, 20, 32, 12, "2999-12-31", place}};
    expectNothing("two halves");
    shot.ignored[1].until = "2020-01-31";
    EXPECT_EQ(decide(gradient()).verdict, Verdict::passed) << "one of them counts again";
    shot.ignored.clear();
    shot.mask = mask;
    shot.maskPlace = place;
    write([](int, int, int) { return 255; });
    expectNothing("a mask of white");
    write([](int x, int, int) { return x < 30 ? 128 : 0; });
    shot.ignored = {{30, 0, 2, 32, "", place}};
    expectNothing("a mask and a rectangle");
}

/// Black in a browser, and white for the comparison: who has looked at it has not seen what it hides.
TEST_F(Noisy, AMaskIsWhatIsShown) {
    ASSERT_EQ(accept(gradient()).verdict, Verdict::updated);
    shot.mask = folder / "mask.png";
    std::vector<std::byte> animated =
        image::encodePng(picture(32, 32, [](int, int y, int) { return y < 9 ? 255 : 0; }));
    animated.resize(animated.size() - 12);  // without its end
    image::putPngChunk(animated, "acTL", std::vector<std::byte>(8));
    image::putPngChunk(animated, "IEND", {});
    writeText(shot.mask, {reinterpret_cast<const char*>(animated.data()), animated.size()});
    const ShotResult result = decide(gradient());
    EXPECT_EQ(result.verdict, Verdict::failed);
    ASSERT_FALSE(result.diagnostics.empty());
    EXPECT_EQ(result.diagnostics.back().id, "suite-E32");
    EXPECT_NE(result.reason.find("the mask 'mask.png'"), std::string::npos) << result.reason;
}

TEST_F(Noisy, ResultsSayHowMuchIsCompared) {
    ASSERT_EQ(accept(gradient()).verdict, Verdict::updated);
    EXPECT_EQ(decide(gradient()).compared, 1);
    shot.ignored = {{0, 0, 32, 16, ""}};
    const ShotResult half = decide(gradient());
    EXPECT_EQ(half.compared, .5);
    ASSERT_FALSE(figures(half).empty());
    EXPECT_EQ(figures(half).front().name, "pixels compared");
    EXPECT_EQ(figures(half).front().value, "512 (50 %)");
    EXPECT_TRUE(half.diagnostics.empty());
    shot.ignored = {{0, 0, 32, 31, ""}, {2, 31, 30, 1, ""}};
    const ShotResult little = decide(gradient());
    EXPECT_EQ(little.verdict, Verdict::passed);
    ASSERT_FALSE(little.diagnostics.empty());
    EXPECT_EQ(little.diagnostics.back().id, "suite-W04");
    EXPECT_EQ(decide(gradient(40)).verdict, Verdict::failed) << "two pixels are compared";
}

TEST_F(Noisy, AnIgnoredRectangleExpires) {
    shot.tolerance.fraction = 0;
    ASSERT_EQ(accept(gradient()).verdict, Verdict::updated);
    shot.ignored = {{10, 5, 20, 1, "2999-12-31"}};
    EXPECT_EQ(decide(withLine(10, 5)).verdict, Verdict::passed);
    shot.ignored[0].until = today();
    EXPECT_EQ(decide(withLine(10, 5)).verdict, Verdict::passed) << "the last day counts";
    shot.ignored[0].until = "2020-01-31";
    EXPECT_EQ(decide(withLine(10, 5)).verdict, Verdict::failed);
}

/// Of pictures of other types, with and without alpha.
TEST_F(Noisy, WhatIsIgnoredIsSoInEveryTypeOfPicture) {
    shot.tolerance = image::exactTolerance();
    shot.statesTolerance = true;
    for (const image::Component golden : {image::Component::u8, image::Component::u16, image::Component::f32})
        for (const image::Component got :
             {image::Component::u8, image::Component::u16, image::Component::f32})
            for (const int alpha : {255, 0}) {
                image::Image expected = image::withComponents(withLine(10, 5), 4);
                for (std::size_t x = 0; x < 32; ++x)
                    expected.data[(5 * 32 + x) * 4 + 3] = static_cast<std::byte>(alpha);
                expected = image::withType(expected, golden);
                const image::Image drawn = image::withType(gradient(), got);
                shot.ignored = {{0, 5, 32, 1, ""}};
                const auto seen = withoutIgnored(shot, expected, drawn);
                ASSERT_TRUE(seen);
                EXPECT_TRUE(image::compare(expected, *seen).identical);
                shot.ignored = {{0, 6, 32, 1, ""}};
                EXPECT_FALSE(image::compare(expected, *withoutIgnored(shot, expected, drawn)).identical);
            }
}

TEST_F(Noisy, AMaskLeavesOutWhatIsWhite) {
    shot.tolerance.fraction = 0;
    ASSERT_EQ(accept(gradient()).verdict, Verdict::updated);
    shot.mask = folder / "mask.png";
    ASSERT_TRUE(
        image::writeImage(picture(32, 32, [](int, int y, int) { return y == 5 ? 255 : 0; }), shot.mask)
            .empty());
    EXPECT_EQ(decide(withLine(10, 5)).verdict, Verdict::passed);
    EXPECT_EQ(decide(withLine(10, 6)).verdict, Verdict::failed);
    image::Image red = picture(32, 32, [](int, int y, int k) { return y == 5 && k == 0 ? 255 : 0; });
    ASSERT_TRUE(image::writeImage(red, shot.mask).empty());
    EXPECT_EQ(decide(withLine(10, 5)).verdict, Verdict::failed) << "only white leaves out";
    ASSERT_TRUE(image::writeImage(picture(16, 32, [](int, int, int) { return 255; }), shot.mask).empty());
    const ShotResult wrong = decide(withLine(10, 5));
    EXPECT_EQ(wrong.verdict, Verdict::failed);
    EXPECT_NE(wrong.reason.find("suite-E29"), std::string::npos) << wrong.reason;
    std::filesystem::remove(shot.mask);
    EXPECT_EQ(decide(withLine(10, 5)).verdict, Verdict::failed);
}

TEST_F(Noisy, ARectangleOutsideOfThePictureIsAnError) {
    ASSERT_EQ(accept(gradient()).verdict, Verdict::updated);
    for (const IgnoredRegion& each :
         {IgnoredRegion{0, 0, 33, 1, ""}, {0, 0, 1, 33, ""}, {32, 0, 1, 1, ""}, {0, 31, 1, 2, ""}}) {
        shot.ignored = {each};
        const ShotResult result = decide(gradient(40));
        EXPECT_EQ(result.verdict, Verdict::failed);
        EXPECT_NE(result.reason.find("suite-E29"), std::string::npos) << result.reason;
    }
}

TEST_F(Noisy, WhatIsIgnoredWronglyIsAnErrorWithItsPlaceEvenIfThePictureIsTheGolden) {
    ASSERT_EQ(accept(gradient()).verdict, Verdict::updated);
    shot.ignored = {{31, 0, 2, 1, "", {"s.toml", 4, 10}}};
    const std::string rectangle =
        "s.toml:4:10: error: ignore: [31, 0, 2, 1] is not inside of the picture of 32 x 32 pixels "
        "[suite-E29]";
    for (const ShotResult& result : {decide(gradient()), accept(gradient()), accept(gradient(40))}) {
        EXPECT_EQ(result.verdict, Verdict::failed);
        EXPECT_EQ(result.reason, rectangle);
        EXPECT_EQ(result.accept, "");
        EXPECT_EQ(result.diagnostics.back().id, "suite-E29") << "reports list it";
    }
    shot.ignored[0].until = "2020-01-31";
    EXPECT_EQ(decide(gradient()).verdict, Verdict::passed) << "it is not ignored any more";
    shot.mask = folder / "mask.png";
    shot.maskPlace = {"s.toml", 5, 8};
    ASSERT_TRUE(image::writeImage(picture(16, 32, [](int, int, int) { return 255; }), shot.mask).empty());
    EXPECT_EQ(decide(gradient()).reason.rfind("s.toml:5:8: error: mask: ", 0), 0U);
    std::filesystem::remove(shot.mask);
    EXPECT_EQ(accept(gradient()).verdict, Verdict::failed) << "a mask that is missing";
}

TEST_F(Noisy, NoGoldenIsMadeOfAShotThatIgnoresWhatItDoesNotHave) {
    shot.ignored = {{70, 0, 80, 60, ""}};
    EXPECT_EQ(accept(gradient()).verdict, Verdict::failed);
    EXPECT_FALSE(std::filesystem::exists(folder / "goldens/a.png"));
}

TEST(Days, AreThoseOfTheCalendar) {
    for (const char* day : {"2026-12-31", "2024-02-29", "2000-02-29", "0001-01-01"})
        EXPECT_TRUE(isDay(day)) << day;
    for (const char* text : {"", "2026-02-29", "1900-02-29", "2026-13-01", "2026-00-10", "2026-1-1",
                             "2026-12-32", "31.12.2026", "2026-12-31T00:00", "2026/12/31", "-026-12-31"})
        EXPECT_FALSE(isDay(text)) << text;
    EXPECT_TRUE(isDay(today())) << today();
}

TEST(NoisyKeys, AreRead) {
    const test::SceneFolder folder{"a.glib"};
    const auto suite = folder.read(
        "[defaults]\nretries = 2\n[[shot]]\nscript = 'a.glib'\nquarantine = '2026-12-31'\nmask = 'm.png'\n"
        "ignore = [[1, 2, 3, 4], { rectangle = [5, 6, 7, 8], until = '2027-01-01' }]\nmax-error = '0.5px'\n"
        "tolerance = { max = 9 }\n");
    ASSERT_TRUE(suite) << folder.shown(suite);
    const Shot& shot = suite->shots.at(0);
    EXPECT_EQ(shot.retries, 2);
    EXPECT_EQ(shot.quarantine, "2026-12-31");
    EXPECT_EQ(shot.mask.filename(), "m.png");
    EXPECT_TRUE(shot.statesTolerance);
    EXPECT_EQ(shot.options.maxError, 0.5);
    ASSERT_EQ(shot.ignored.size(), 2U);
    EXPECT_EQ(shot.ignored[0].height, 4);
    EXPECT_EQ(shot.ignored[1].until, "2027-01-01");
    EXPECT_EQ(shot.ignored[1].place.line, 7);
    EXPECT_EQ(shot.maskPlace.line, 6);
}

TEST(NoisyKeys, AreCheckedWithTheirPlace) {
    const test::SceneFolder folder{"a.glib"};
    for (const auto& [line, id] :
         {std::pair{"quarantine = '2026-02-30'", "suite-E30"},
          {"quarantine = 5", "suite-E03"},
          {"retries = -1", "suite-E04"},
          {"retries = 2.5", "suite-E03"},
          {"ignore = [1, 2, 3, 4]", "suite-E03"},
          {"ignore = [[1, 2, 3]]", "suite-E03"},
          {"ignore = [[-1, 2, 3, 4]]", "suite-E04"},
          {"ignore = [[1, 2, 0, 4]]", "suite-E04"},
          {"ignore = [{ until = '2027-01-01' }]", "suite-E03"},
          {"ignore = [{ rectangle = [1, 2, 3, 4], untill = '2027-01-01' }]", "suite-E02"},
          {"ignore = [{ rectangle = [1, 2, 3, 4], until = 'soon' }]", "suite-E30"},
          {"max-error = '0.5em'", "suite-E04"},
          {"max-error = 'px'", "suite-E04"},
          {"samples = '4'", "suite-E03"}}) {
        const auto suite = folder.read(std::string("[[shot]]\nscript = 'a.glib'\n") + line + "\n");
        ASSERT_FALSE(suite) << line;
        EXPECT_EQ(suite.diagnostics.front().id, id) << line << ": " << suite.message();
        EXPECT_EQ(suite.diagnostics.front().place.line, 3) << line;
    }
}

}  // namespace
}  // namespace glibra::suite
