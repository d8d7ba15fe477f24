#include "suite/run/run.h"

#include <gtest/gtest.h>

#include "suite/options/option_words.h"
#include "suite/report/terminal_report.h"
#include "suite/run/run_options.h"

namespace glibra::suite {
namespace {

TEST(Pieces, HoldEveryItemOnceInOrder) {
    for (const std::size_t count : {0U, 1U, 2U, 7U, 100U, 5000U})
        for (const int workers : {1, 2, 16}) {
            std::size_t next = 0;
            for (const auto& piece : planPieces(count, workers, [](std::size_t) { return true; }))
                for (const std::size_t item : piece) EXPECT_EQ(item, next++);
            EXPECT_EQ(next, count);
        }
}

TEST(Pieces, EndWithSingleItemsForEveryWorker) {
    const auto pieces = planPieces(400, 4, [](std::size_t) { return true; });
    for (std::size_t i = 1; i < pieces.size(); ++i) EXPECT_LE(pieces[i].size(), pieces[i - 1].size());
    EXPECT_EQ(pieces.front().size(), 16U);
    for (std::size_t i = 1; i <= 8; ++i) EXPECT_EQ(pieces[pieces.size() - i].size(), 1U);
}

TEST(Pieces, AreNotCutForOneWorker) {
    EXPECT_EQ(planPieces(5000, 1, [](std::size_t) { return true; }).size(), 1U);
}

TEST(Pieces, JoinOnlyWhatMayBeTogether) {
    for (const auto& piece : planPieces(300, 1, [](std::size_t i) { return i % 5 != 0; }))
        for (std::size_t i = 1; i < piece.size(); ++i) EXPECT_NE(piece[i] % 5, 0U);
}

TEST(Messages, ComeBack) {
    const auto driver = parseMessage(toText(DriverIs{"llvmpipe, 4.5", "key"}));
    ASSERT_TRUE(driver);
    EXPECT_EQ(std::get<DriverIs>(*driver).words, "llvmpipe, 4.5");
    EXPECT_EQ(std::get<DriverIs>(*driver).key, "key");

    for (const Phase::Kind kind :
         {Phase::Kind::awaits, Phase::Kind::drawn, Phase::Kind::judges, Phase::Kind::recalls}) {
        const auto phase = parseMessage(toText(Phase{kind, {7, 9}}));
        ASSERT_TRUE(phase);
        EXPECT_EQ(std::get<Phase>(*phase).kind, kind);
        EXPECT_EQ(std::get<Phase>(*phase).shot, (ShotReference{7, 9}));
    }

    const auto begins = parseMessage(toText(Begins{{3, 4711}}));
    ASSERT_TRUE(begins);
    EXPECT_EQ(std::get<Begins>(*begins).shot, (ShotReference{3, 4711}));

    Done done{{1, 2}, {}, AcceptedHash{"a", "", {1, 2}, {3, 4}, "key"}};
    done.result.suite = "s";
    done.result.shot = "a";
    done.result.verdict = Verdict::failed;
    done.result.reason = "two\nlines";
    const auto back = parseMessage(toText(done));
    ASSERT_TRUE(back);
    EXPECT_EQ(std::get<Done>(*back).result.reason, "two\nlines");
    EXPECT_EQ(std::get<Done>(*back).accepted->pixels, (Hash{3, 4}));
    done.accepted.reset();
    EXPECT_FALSE(std::get<Done>(*parseMessage(toText(done))).accepted);
}

TEST(Messages, NonsenseIsNotAMessage) {
    for (const char* bad : {"", "x", "b 1", "q 1 2\n", "d 1 2\nno json\n"})
        EXPECT_FALSE(parseMessage(bad)) << bad;
}

TEST(Commands, CanBePastedIntoAShell) {
    EXPECT_EQ(shellWord("glib/a_b-1.glib"), "glib/a_b-1.glib");
    EXPECT_EQ(shellWord("it's"), "'it'\\''s'");
    EXPECT_EQ(shellWord(""), "''");
    EXPECT_EQ(shellWord("a b;$c"), "'a b;$c'");
    Shot shot;
    shot.name = "start/a@t=1";
    shot.script = "my scenes/a.glib";
    shot.options.width = 200;
    shot.options.height = 100;
    shot.options.time = 0.1;
    shot.options.set = {"uColor=1,.5,0"};
    shot.options.floatPixels = true;
    EXPECT_EQ(
        reproduceCommand(shot),
        "glibra render 'my scenes/a.glib' --size 200x100 --time 0.1 --set uColor=1,.5,0 -o start_a@t=1.exr");
}

}  // namespace
}  // namespace glibra::suite
