#include "suite/run/verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <utility>

#include "folder.h"
#include "image/png/png_writer.h"
#include "pictures.h"

namespace glibra::suite {
namespace {

class Verdicts : public testing::Test {
  protected:
    Verdicts() {
        suite.name = "s";
        suite.file = "s.toml";
        suite.goldens = folder / "goldens";
    }
    ShotJudge judge(JudgeOptions options = {}, const std::string& family = "llvmpipe") {
        options.results = folder / "results";
        store = *GoldenStore::open(suite);
        return {suite, store, family, key, options};
    }
    /// The verdict of a run on the picture: first() and, if necessary, second() with `again`.
    Judged decide(const Shot& which, const image::Image& image, JudgeOptions options = {},
                  const std::optional<image::Image>& again = {}, const std::string& family = "llvmpipe") {
        const ShotJudge judge = this->judge(std::move(options), family);
        const Attempt attempt = attemptAt(which, image);
        if (std::optional<Judged> first = judge.first(attempt)) return *first;
        return judge.second(attempt, attemptAt(which, again ? *again : image));
    }
    /// Runs --update and adds the accepted pixels to the list.
    ShotResult accept(const Shot& which, const image::Image& image, JudgeOptions options = {}) {
        options.update = true;
        const Judged judged = decide(which, image, options);
        if (judged.accepted) {
            EXPECT_TRUE(acceptHashes(store.hashFile(), std::vector{*judged.accepted}).empty());
        }
        return judged.result;
    }
    bool exists(const std::filesystem::path& path) const { return std::filesystem::exists(folder / path); }
    image::Image golden(const Shot& which) { return *decode(*store.find(which, "llvmpipe")); }

    Folder folder;
    Suite suite;
    GoldenStore store = *GoldenStore::open(suite);
    Shot shot = shotNamed("a");
    std::string key = "key";
};

TEST_F(Verdicts, WithoutAGoldenItIsMissingAndThePictureIsThere) {
    const ShotResult result = decide(shot, gradient()).result;
    EXPECT_EQ(result.verdict, Verdict::missing);
    EXPECT_TRUE(exists("results" / result.got));
    EXPECT_EQ(result.accept, "glibra test s.toml --only a --update --allow-outside");
}

TEST_F(Verdicts, UpdateMakesTheGoldenAndTheNextRunIsExact) {
    const ShotResult made = accept(shot, gradient());
    EXPECT_EQ(made.verdict, Verdict::updated);
    EXPECT_TRUE(exists("goldens/a.png"));
    const ShotResult next = decide(shot, gradient()).result;
    EXPECT_EQ(next.verdict, Verdict::passed);
    EXPECT_TRUE(next.exact);
    EXPECT_FALSE(next.changed);
    EXPECT_EQ(next.expected, folder / "goldens/a.png");
    EXPECT_TRUE(next.got.empty());
}

/// A line of the list for a wrong picture, or for a golden that is no picture, passes nothing.
TEST_F(Verdicts, NoLineOfTheListPassesAWrongPicture) {
    accept(shot, gradient());
    const auto forge = [&](const image::Image& pixels) {
        const Golden golden = *GoldenStore::open(suite)->find(shot, "llvmpipe");
        ASSERT_TRUE(acceptHashes(GoldenStore::open(suite)->hashFile(),
                                 std::vector{AcceptedHash{"a", "", golden.identity, hashOf(pixels), "key"}})
                        .empty());
    };
    forge(gradient(40));
    EXPECT_EQ(decide(shot, gradient(40)).result.verdict, Verdict::failed);
    EXPECT_EQ(decide(shot, gradient()).result.verdict, Verdict::passed);
    writeText(folder / "goldens/a.png", "no picture");
    forge(gradient());
    const ShotResult unreadable = decide(shot, gradient()).result;
    EXPECT_EQ(unreadable.verdict, Verdict::failed);
    EXPECT_NE(unreadable.reason.find("--update"), std::string::npos) << unreadable.reason;
}

TEST_F(Verdicts, WithinTheToleranceOfTheGoldenButOtherThanBeforeIsChanged) {
    accept(shot, gradient());
    image::Image other = gradient();
    other.data[40] ^= std::byte{1};
    const ShotResult result = decide(shot, other).result;
    EXPECT_EQ(result.verdict, Verdict::passed);
    EXPECT_FALSE(result.exact);
    EXPECT_TRUE(result.changed);
    for (const auto& each : {result.got, result.expected, result.difference})
        EXPECT_TRUE(exists("results" / each)) << "the new picture can be looked at: " << each;
    EXPECT_EQ(result.acceptKey, "key");
}

TEST_F(Verdicts, AToleranceThatPassesEveryPictureIsAnError) {
    shot.statesTolerance = true;
    const auto judged = [&](const image::Image& got, const image::Tolerance& tolerance) {
        shot.tolerance = tolerance;
        return decide(shot, got).result;
    };
    accept(shot, gradient());
    using image::Tolerance;
    for (const Tolerance& each : {Tolerance{.fraction = 1, .cluster = 100'000, .line = 1000, .bias = 255},
                                  Tolerance{.fraction = 1, .cluster = 1024, .line = 32, .bias = 3},
                                  Tolerance{.largest = 255, .bias = 255}}) {
        const ShotResult result = judged(gradient(60), each);
        EXPECT_NE(result.verdict, Verdict::passed);
        EXPECT_EQ(judged(gradient(), each).verdict, Verdict::passed) << "equal pictures are equal";
        ASSERT_FALSE(result.diagnostics.empty()) << result.reason;
        EXPECT_EQ(result.diagnostics.back().id, "suite-E33");
    }
    EXPECT_EQ(judged(gradient(40), {.largest = 60, .bias = 60}).verdict, Verdict::passed);
    EXPECT_EQ(judged(gradient(1), {.fraction = 1, .cluster = 1000, .line = 31}).verdict, Verdict::passed);
}

TEST(PassesAll, OfFloatsIsWhatPassesPicturesFarAway) {
    using image::Tolerance;
    for (const Tolerance& each :
         {Tolerance{.relative = 2}, Tolerance{.relative = 1}, Tolerance{.absolute = 1e30},
          Tolerance{.absolute = 50}, Tolerance{.fraction = 1, .cluster = 64, .line = 8}})
        EXPECT_TRUE(image::passesAll(floats(.5F, .7F), each));
    for (const Tolerance& each : {Tolerance{}, Tolerance{.relative = .5}, Tolerance{.absolute = 5},
                                  Tolerance{.fraction = .9, .cluster = 64, .line = 8}})
        EXPECT_FALSE(image::passesAll(floats(.5F, .7F), each));
    EXPECT_FALSE(image::passesAll(floats(1e6F, 2), {.absolute = 1000}));
    EXPECT_FALSE(image::passesAll(floats(0, NAN), {}));
}

TEST_F(Verdicts, UpdateKeepsAGoldenThatStillFitsAndAcceptsTheNewPixels) {
    accept(shot, gradient());
    const std::string before = textOf(folder / "goldens/a.png");
    image::Image other = gradient();
    other.data[40] ^= std::byte{1};
    EXPECT_EQ(accept(shot, other).verdict, Verdict::passed);
    EXPECT_EQ(textOf(folder / "goldens/a.png"), before);
    const ShotResult next = decide(shot, other).result;
    EXPECT_EQ(next.verdict, Verdict::passed);
    EXPECT_FALSE(next.changed);
}

TEST_F(Verdicts, AnotherPictureFailsWithAllThatAReportShows) {
    accept(shot, gradient());
    const ShotResult result = decide(shot, gradient(40)).result;
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_FALSE(result.reason.empty());
    EXPECT_FALSE(result.judgement.same);
    EXPECT_NEAR(result.judgement.comparison.largest, 40 / 255.0, 1e-6);
    for (const auto& each : {result.got, result.expected, result.difference}) {
        EXPECT_FALSE(each.empty());
        EXPECT_TRUE(each.is_relative());
        EXPECT_TRUE(exists("results" / each)) << each;
    }
}

TEST_F(Verdicts, AnotherSizeFails) {
    accept(shot, gradient());
    const ShotResult result = decide(shot, picture(16, 32, [](int x, int y, int) { return x + y; })).result;
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_EQ(result.width, 16);
}

TEST_F(Verdicts, TwoRenderingsThatDifferAreUnstable) {
    accept(shot, gradient());
    const ShotResult result = decide(shot, gradient(40), {}, gradient(41)).result;
    EXPECT_EQ(result.verdict, Verdict::unstable);
    EXPECT_FALSE(result.judgement.comparison.identical);
    EXPECT_TRUE(exists("results" / result.expected));
}

TEST_F(Verdicts, AnUnstablePictureBecomesNoGolden) {
    const ShotResult result = decide(shot, gradient(), {.update = true, .force = true}, gradient(1)).result;
    EXPECT_EQ(result.verdict, Verdict::unstable);
    EXPECT_FALSE(exists("goldens/a.png"));
}

TEST_F(Verdicts, UpdateReplacesWhatDiffersAndSaysByHowMuch) {
    accept(shot, gradient());
    const ShotResult result = accept(shot, gradient(40));
    EXPECT_EQ(result.verdict, Verdict::updated);
    EXPECT_EQ(result.reason.rfind("golden replaced: ", 0), 0U) << result.reason;
    EXPECT_GT(result.reason.size(), std::string("golden replaced: ").size());
    EXPECT_NEAR(result.judgement.comparison.largest, 40 / 255.0, 1e-6);
    EXPECT_TRUE(exists("results" / result.expected)) << "the old one, to look at";
    EXPECT_TRUE(image::compare(golden(shot), gradient(40)).identical);
}

TEST_F(Verdicts, AGoodGoldenIsNotReplacedByOneColourWithoutForce) {
    accept(shot, gradient());
    const ShotResult refused = accept(shot, oneColor(90));
    EXPECT_EQ(refused.verdict, Verdict::refused);
    EXPECT_NE(refused.reason.find("one colour"), std::string::npos) << refused.reason;
    EXPECT_TRUE(image::compare(golden(shot), gradient()).identical);

    EXPECT_EQ(accept(shot, oneColor(90), {.force = true}).verdict, Verdict::updated);
    EXPECT_TRUE(image::compare(golden(shot), oneColor(90)).identical);
    EXPECT_EQ(accept(shot, oneColor(200)).verdict, Verdict::updated) << "the old one is no better";
}

TEST_F(Verdicts, ANewGoldenOfOneColourNeedsForceToo) {
    EXPECT_EQ(accept(shot, oneColor(0)).verdict, Verdict::refused);
    EXPECT_FALSE(exists("goldens/a.png"));
}

TEST_F(Verdicts, NanTransparencyAndOneColourAreNoGoldens) {
    EXPECT_NE(whyNoGolden(floats(1.F, std::nanf(""))), "");
    EXPECT_NE(whyNoGolden(floats(1.F, INFINITY)), "");
    EXPECT_NE(whyNoGolden(floats(1.F, 1.F)), "");
    EXPECT_EQ(whyNoGolden(floats(1.F, 2.F)), "");
    image::Image clear{2, 1, 4, image::Component::u8, std::vector<std::byte>(8)};
    clear.data[0] = std::byte{9};
    EXPECT_NE(whyNoGolden(clear), "");
    clear.data[3] = std::byte{1};
    EXPECT_EQ(whyNoGolden(clear), "");
    EXPECT_EQ(whyNoGolden(gradient()), "");
}

/// Nobody has accepted that such a golden goes: what stands in its place is kept, and the message says what
/// to do.
TEST_F(Verdicts, AGoldenThatCannotBeReadIsReplacedOnlyOnRequest) {
    std::vector<std::byte> animated = image::encodePng(gradient());
    animated.resize(animated.size() - 12);  // without its end
    image::putPngChunk(animated, "acTL", std::vector<std::byte>(8));
    image::putPngChunk(animated, "IEND", {});
    const std::pair<std::string, const char*> kinds[] = {
        {"\x89PNG\r\n\x1a\nand no more", "damaged"},
        {"", "empty"},
        {"version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 9\n", "git lfs pull"},
        {"<<<<<<< HEAD\nversion https://git-lfs.github.com/spec/v1\n", "merge conflict"},
        {"\n<!DOCTYPE html><title>404</title>", "web page"},
        {"some text", "neither a picture"},
        {std::string(reinterpret_cast<const char*>(animated.data()), animated.size()), "animation"},
        {"GIF89a", "GIF"},
    };
    for (const auto& [content, word] : kinds) {
        writeText(folder / "goldens/a.png", content);
        const ShotResult failed = decide(shot, gradient()).result;
        EXPECT_EQ(failed.verdict, Verdict::failed) << word;
        EXPECT_NE(failed.reason.find(word), std::string::npos) << failed.reason;
        for (const JudgeOptions& options :
             {JudgeOptions{}, JudgeOptions{.force = true}, JudgeOptions{.also = true},
              JudgeOptions{.variant = true}, JudgeOptions{.onlyMissing = true}}) {
            const ShotResult kept = accept(shot, gradient(), options);
            EXPECT_TRUE(isFailure(kept.verdict)) << word << ": " << name(kept.verdict);
            EXPECT_NE(kept.reason.find(word), std::string::npos) << kept.reason;
            EXPECT_EQ(textOf(folder / "goldens/a.png"), content) << word;
        }
        EXPECT_EQ(accept(shot, gradient(), {.replaceUnreadable = true}).verdict, Verdict::updated) << word;
        EXPECT_EQ(decide(shot, gradient()).result.verdict, Verdict::passed) << word;
    }
    std::filesystem::remove(folder / "goldens/a.png");
    std::filesystem::create_directories(folder / "goldens/a.png");
    EXPECT_EQ(accept(shot, gradient()).verdict, Verdict::refused) << "a folder in its place";
}

/// A picture that is accepted besides is a golden, too.
TEST_F(Verdicts, AFurtherPictureThatCannotBeReadIsNamed) {
    accept(shot, gradient());
    writeText(folder / "goldens/a.also1.png", "version https://git-lfs.github.com/spec/v1\n");
    const ShotResult failed = decide(shot, gradient(40)).result;
    EXPECT_NE(failed.reason.find("Git LFS"), std::string::npos) << failed.reason;
    EXPECT_EQ(decide(shot, gradient()).result.verdict, Verdict::passed);
}

TEST_F(Verdicts, UpdateOfOnlyWhatIsMissingLeavesTheOthers) {
    accept(shot, gradient());
    const JudgeOptions missing{.onlyMissing = true};
    EXPECT_EQ(accept(shot, gradient(40), missing).verdict, Verdict::failed);
    EXPECT_TRUE(image::compare(golden(shot), gradient()).identical);
    EXPECT_EQ(accept(shotNamed("b"), gradient(40), missing).verdict, Verdict::updated);
}

class Drivers : public Verdicts {
  protected:
    ShotResult acceptBy(const std::string& drawnBy, const Shot& which, const image::Image& image,
                        JudgeOptions options = {}) {
        key = drawnBy;
        return accept(which, image, std::move(options));
    }
    static constexpr const char* kMesa =
        "llvmpipe (LLVM 15.0.6, 256 bits); 4.5 Mesa 22.3.6; AuthenticAMD avx2";
    static constexpr const char* kNewMesa =
        "llvmpipe (LLVM 19.1.7, 256 bits); 4.6 Mesa 25.0; GenuineIntel avx2";
    static constexpr const char* kCard = "NVIDIA GeForce RTX 3080/PCIe/SSE2; 4.6.0 NVIDIA 535.54";
};

TEST_F(Drivers, UpdateKeepsAGoldenForAllDriversThatAnotherFamilyDrew) {
    EXPECT_EQ(acceptBy(kMesa, shot, gradient()).verdict, Verdict::updated);
    const ShotResult kept = acceptBy(kCard, shot, gradient(40));
    EXPECT_EQ(kept.verdict, Verdict::refused);
    for (const char* word : {"llvmpipe", "nvidia", "--variant", "--any-driver"})
        EXPECT_NE(kept.reason.find(word), std::string::npos) << kept.reason;
    EXPECT_TRUE(image::compare(golden(shot), gradient()).identical);
    // A golden that is new stands among those of the suite.
    EXPECT_EQ(acceptBy(kCard, shotNamed("b"), gradient(40)).verdict, Verdict::refused);
    EXPECT_FALSE(exists("goldens/b.png"));
    const ShotResult beside = acceptBy(kCard, shot, gradient(40), {.variant = true});
    EXPECT_EQ(beside.verdict, Verdict::updated);
    EXPECT_NE(beside.reason.find("golden for llvmpipe added"), std::string::npos) << beside.reason;
    std::filesystem::remove(folder / "goldens/a.llvmpipe.png");
    EXPECT_EQ(acceptBy(kNewMesa, shot, gradient(20)).verdict, Verdict::updated) << "the same family";
    EXPECT_EQ(acceptBy(kCard, shot, gradient(40), {.anyDriver = true}).verdict, Verdict::updated);
    EXPECT_EQ(acceptBy(kCard, shot, gradient(60)).verdict, Verdict::updated) << "it is its own now";
}

TEST_F(Drivers, ADriverThatOnlyPassesHasNotDrawnTheGolden) {
    acceptBy(kMesa, shot, gradient());
    image::Image near = gradient();
    near.data[40] ^= std::byte{1};
    EXPECT_EQ(acceptBy(kCard, shot, near).verdict, Verdict::passed);
    EXPECT_EQ(acceptBy(kCard, shot, gradient(40)).verdict, Verdict::refused);
    EXPECT_EQ(acceptBy(kCard, shot, gradient()).verdict, Verdict::passed);
    EXPECT_EQ(acceptBy(kCard, shot, gradient(40)).verdict, Verdict::updated)
        << "it has drawn exactly this picture";
}

TEST_F(Drivers, WithoutLinesNothingIsKnown) {
    acceptBy(kMesa, shot, gradient());
    std::filesystem::remove(folder / "goldens/s.hashes");
    EXPECT_EQ(acceptBy(kCard, shot, gradient(40)).verdict, Verdict::updated);
}

class Renamed : public Verdicts {
  protected:
    Renamed() {
        accept(shotNamed("old"), gradient());
        orphans = std::make_shared<const Orphans>(std::vector{folder / "goldens/old.png"});
    }
    std::shared_ptr<const Orphans> orphans;
};

TEST_F(Renamed, AMissingGoldenIsThatOfNoShotWithTheSamePicture) {
    const ShotResult same = decide(shot, gradient(), {.orphans = orphans}).result;
    EXPECT_EQ(same.verdict, Verdict::missing);
    EXPECT_EQ(same.renamedFrom, folder / "goldens/old.png");
    EXPECT_NE(same.reason.find("renamed"), std::string::npos) << same.reason;
    EXPECT_EQ(same.accept, "glibra test s.toml --only a --rename --allow-outside");
    const ShotResult other = decide(shot, gradient(1), {.orphans = orphans}).result;
    EXPECT_TRUE(other.renamedFrom.empty());
}

TEST_F(Renamed, AMissingGoldenMayBeThatOfNoShotWithASimilarPictureOrName) {
    const Shot changed = shotNamed("another/scene@t=2.5");
    const ShotResult near = decide(changed, gradient(2), {.orphans = orphans}).result;
    EXPECT_EQ(near.verdict, Verdict::missing);
    EXPECT_EQ(near.nearTo, folder / "goldens/old.png");
    EXPECT_TRUE(near.renamedFrom.empty());
    EXPECT_NE(near.reason.find("--rename"), std::string::npos) << near.reason;
    EXPECT_FALSE(near.expected.empty()) << "both pictures are shown";
    // Neither the picture nor the name is similar.
    const image::Image other = [&] {
        image::Image made = gradient();
        for (std::size_t i = 0; i < made.data.size(); ++i)
            made.data[i] = static_cast<std::byte>((i * i * 31) >> 3U);
        return made;
    }();
    EXPECT_TRUE(decide(changed, other, {.orphans = orphans}).result.nearTo.empty());
    EXPECT_EQ(decide(shotNamed("olds"), other, {.orphans = orphans}).result.nearTo,
              folder / "goldens/old.png");
}

TEST_F(Renamed, UpdateWithPruneTakesNoChangedPicture) {
    const JudgeOptions options{.prune = true, .orphans = orphans};
    const ShotResult changed = accept(shot, gradient(40), options);
    EXPECT_EQ(changed.verdict, Verdict::refused);
    EXPECT_NE(changed.reason.find("renamed"), std::string::npos) << changed.reason;
    EXPECT_FALSE(exists("goldens/a.png"));
    EXPECT_EQ(accept(shot, gradient(), options).verdict, Verdict::updated);
    EXPECT_EQ(accept(shotNamed("b"), gradient(40), {.prune = true}).verdict, Verdict::updated)
        << "nothing is lost";
}

TEST_F(Renamed, TheGoldenItsVariantsAndItsLinesTakeTheNewName) {
    store = *GoldenStore::open(suite);
    ASSERT_TRUE(store.replace(shotNamed("old"), "nvidia", gradient(9)));
    ASSERT_TRUE(store.replace(shotNamed("older"), "", gradient(8)));
    const std::vector files{folder / "goldens/old.nvidia.png", folder / "goldens/old.png",
                            folder / "goldens/older.png"};
    EXPECT_TRUE(store.rename(files[1], shotNamed("sub/new"), files).empty());
    for (const char* each : {"goldens/sub/new.png", "goldens/sub/new.nvidia.png", "goldens/older.png"})
        EXPECT_TRUE(exists(each)) << each;
    EXPECT_FALSE(exists("goldens/old.png"));
    const std::string list = textOf(folder / "goldens/s.hashes");
    EXPECT_NE(list.find("\nsub/new - "), std::string::npos) << list;
    EXPECT_EQ(list.find("\nold - "), std::string::npos) << list;
    const Diagnostics taken = store.rename(files[2], shotNamed("sub/new"), files);
    ASSERT_FALSE(taken.empty());
    EXPECT_EQ(taken.front().id, "file-E10");
}

TEST_F(Verdicts, AVariantIsForOneFamilyOnly) {
    accept(shot, gradient());
    const JudgeOptions variant{.update = true, .variant = true};
    EXPECT_EQ(decide(shot, gradient(40), variant, {}, "nvidia").result.verdict, Verdict::updated);
    EXPECT_TRUE(exists("goldens/a.nvidia.png"));
    EXPECT_EQ(decide(shot, gradient()).result.verdict, Verdict::passed);
    const ShotResult there = decide(shot, gradient(40), {}, {}, "nvidia").result;
    EXPECT_EQ(there.verdict, Verdict::passed);
    EXPECT_EQ(there.goldenVariant, "nvidia");
}

TEST_F(Verdicts, TheGoldenForAllDriversIsRightForAFamilyToo) {
    accept(shot, gradient());
    const JudgeOptions variant{.update = true, .variant = true};
    ASSERT_EQ(decide(shot, gradient(40), variant, {}, "nvidia").result.verdict, Verdict::updated);
    const ShotResult general = decide(shot, gradient(), {}, {}, "nvidia").result;
    EXPECT_EQ(general.verdict, Verdict::passed);
    EXPECT_EQ(general.goldenVariant, "");
    EXPECT_EQ(decide(shot, gradient(80), {}, {}, "nvidia").result.verdict, Verdict::failed);
    // But a golden that cannot be read is a fault, whatever the other says.
    std::ofstream(folder / "goldens/a.nvidia.png") << "no picture";
    EXPECT_NE(decide(shot, gradient(), {}, {}, "nvidia").result.verdict, Verdict::passed);
}

class Failures : public Verdicts {
  protected:
    ShotResult fails(const Diagnostics& diagnostics) {
        Attempt attempt;
        attempt.shot = &shot;
        attempt.own.diagnostics = diagnostics;
        return judge().first(attempt)->result;
    }
    const Diagnostic compile = diagnose("glsl-E01", "'uColour' is not declared", {"a.frag", 7, 3});
};

TEST_F(Failures, ASceneWithErrorsIsReportedByItsFirstError) {
    const ShotResult result = fails({diagnose("glib-W04", "remark"), compile});
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_EQ(result.reason, toString(compile));
    EXPECT_EQ(result.diagnostics.size(), 2U);
}

TEST_F(Failures, AnExpectedErrorPasses) {
    for (const ExpectedError& expected :
         {ExpectedError{}, ExpectedError{"glsl-E01", "", 0}, ExpectedError{"glsl-E01", "uColour", 7},
          ExpectedError{"", "not declared", 0}}) {
        shot.expectedError = expected;
        EXPECT_EQ(fails({compile}).verdict, Verdict::passed) << toPhrase(expected);
    }
}

TEST_F(Failures, AnotherErrorThanTheExpectedOneFails) {
    for (const ExpectedError& expected : {ExpectedError{"glsl-E02", "", 0}, ExpectedError{"glsl-E01", "", 8},
                                          ExpectedError{"", "uColor ", 0}}) {
        shot.expectedError = expected;
        EXPECT_EQ(fails({compile}).verdict, Verdict::failed) << toPhrase(expected);
    }
    shot.expectedError = ExpectedError{"glib-W04", "", 0};
    EXPECT_EQ(fails({diagnose("glib-W04", "only a warning"), compile}).verdict, Verdict::failed);
}

TEST_F(Failures, AnExpectedErrorThatDoesNotComeFails) {
    shot.expectedError = ExpectedError{"glsl-E01", "", 0};
    const ShotResult result = decide(shot, gradient()).result;
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_NE(result.reason.find("glsl-E01"), std::string::npos);
    EXPECT_TRUE(result.accept.empty());
}

class Pairs : public Verdicts {
  protected:
    ShotResult against(const image::Image& own, const image::Image& partner, bool match) {
        shot.golden = false;
        (match ? shot.match : shot.differ) = "b";
        Attempt attempt = attemptAt(shot, own);
        (match ? attempt.match : attempt.differ).emplace().picture = partner;
        const ShotJudge judge = this->judge();
        if (std::optional<Judged> first = judge.first(attempt)) return first->result;
        return judge.second(attempt, attempt).result;
    }
};

TEST_F(Pairs, AMatchHasToBeTheSamePicture) {
    EXPECT_EQ(against(gradient(), gradient(), true).verdict, Verdict::passed);
    const ShotResult result = against(gradient(), gradient(40), true);
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_NE(result.reason.find("'b'"), std::string::npos);
    EXPECT_TRUE(exists("results" / result.expected)) << "the partner's picture";
}

TEST_F(Pairs, AMatchByAToleranceThatPassesEveryPictureIsAnError) {
    shot.statesTolerance = true;
    shot.tolerance = {.fraction = 1, .cluster = 1024, .line = 32, .bias = 255};
    EXPECT_EQ(against(gradient(), gradient(), true).verdict, Verdict::passed);
    const ShotResult result = against(gradient(), gradient(60), true);
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_NE(result.reason.find("passes every picture"), std::string::npos) << result.reason;
}

TEST_F(Pairs, APairThatHasToDifferMayNotBeTheSame) {
    EXPECT_EQ(against(gradient(), gradient(40), false).verdict, Verdict::passed);
    EXPECT_EQ(against(gradient(), gradient(), false).verdict, Verdict::failed);
}

TEST_F(Failures, ACheckThatFailsIsRepeatedByCheck) {
    Attempt attempt = attemptAt(shot, gradient());
    attempt.own.failedChecks.push_back(diagnose("check-E01", "Expect (k == 1): expected true, found k is 2"));
    shot.options.width = shot.options.height = 32;
    const ShotResult result = judge().first(attempt)->result;
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_EQ(result.reproduce, "glibra check --run " + shot.script.string() + " --size 32x32");
    EXPECT_EQ(result.accept, "") << "a golden does not make the check hold";
    shot.options.axes = true;  // which `glibra check` does not have
    EXPECT_TRUE(judge().first(attempt)->result.reproduce.starts_with("glibra render "));
}

TEST_F(Pairs, APartnerThatFailsFailsThePair) {
    shot.golden = false;
    shot.match = "b";
    Attempt attempt = attemptAt(shot, gradient());
    attempt.match.emplace().diagnostics.push_back(diagnose("glib-E01", "unknown command"));
    const ShotJudge judge = this->judge();
    ASSERT_FALSE(judge.first(attempt));
    const ShotResult result = judge.second(attempt, attempt).result;
    EXPECT_EQ(result.verdict, Verdict::failed);
    EXPECT_NE(result.reason.find("unknown command"), std::string::npos);
}

TEST_F(Pairs, UpdateDoesNotHideABrokenPair) {
    shot.match = "b";
    Attempt attempt = attemptAt(shot, gradient());
    attempt.match.emplace().picture = gradient(40);
    const ShotJudge judge = this->judge({.update = true});
    EXPECT_EQ(judge.second(attempt, attempt).result.verdict, Verdict::failed);
}

}  // namespace
}  // namespace glibra::suite
