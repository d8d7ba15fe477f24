#include "base/workers.h"

#include <gtest/gtest.h>

#include <span>
#include <thread>

namespace glibra::base {
namespace {

/// What arrives at the other end of a pipe.
WorkerCalls sent(const std::string& bytes) {
    system::File reading, writing;
    EXPECT_EQ(makePipe(reading, writing), 0);
    std::thread writer([&] {
        writeAll(writing, std::as_bytes(std::span(bytes)));
        writing.close();
    });
    WorkerCalls calls = receiveCalls(reading);
    writer.join();
    return calls;
}

TEST(EarlierCalls, ArriveAsTheyWere) {
    Outcome crashed{.end = Outcome::End::crashed, .signal = 11, .process = 4711, .nearMemoryLimit = true};
    Outcome lost{.end = Outcome::End::deviceLost, .wasAlone = true};
    lost.lost.cause = ResetCause::other;
    lost.lost.place = {"a scene.glib", 7, 3};
    WorkerCalls calls;
    calls[numberOfCall("run.cpp:12", 0)] = {
        {.index = 3, .text = "frame 1\nof 2"},
        {WorkerEvent::Kind::repeated, 3, crashed},
        {WorkerEvent::Kind::done, 3, {.answer = std::string("a\0b", 3)}},
        {WorkerEvent::Kind::done, 1, lost},
    };
    calls[numberOfCall("run.cpp:12", 1)] = {};
    const WorkerCalls got = sent(toBytes(calls));
    ASSERT_EQ(got.size(), 2U);
    const auto& events = got.at(numberOfCall("run.cpp:12", 0));
    ASSERT_EQ(events.size(), 4U);
    EXPECT_EQ(events[0].kind, WorkerEvent::Kind::progress);
    EXPECT_EQ(events[0].index, 3U);
    EXPECT_EQ(events[0].text, "frame 1\nof 2");
    EXPECT_EQ(events[1].kind, WorkerEvent::Kind::repeated);
    EXPECT_EQ(events[1].outcome.end, Outcome::End::crashed);
    EXPECT_EQ(events[1].outcome.signal, 11);
    EXPECT_EQ(events[1].outcome.process, 4711);
    EXPECT_TRUE(events[1].outcome.nearMemoryLimit);
    EXPECT_EQ(events[2].outcome.answer, std::string("a\0b", 3));
    EXPECT_EQ(events[3].outcome.lost.cause, ResetCause::other);
    EXPECT_EQ(events[3].outcome.lost.place.line, 7);
    EXPECT_TRUE(events[3].outcome.wasAlone);
    EXPECT_TRUE(got.at(numberOfCall("run.cpp:12", 1)).empty());
    EXPECT_TRUE(sent(toBytes({})).empty());
}

TEST(EarlierCalls, AreNothingIfThePipeHasSomethingElse) {
    EXPECT_TRUE(sent("").empty());
    EXPECT_TRUE(sent("short").empty());
    EXPECT_TRUE(sent(std::string(8, '\xff')).empty());
    std::string cut = toBytes({{1, {{.index = 2, .text = "text"}}}});
    cut.pop_back();
    EXPECT_TRUE(sent(cut).empty());
    // A length that goes beyond the end is the end.
    std::string wrong = toBytes({{1, {{.index = 2, .text = "text"}}}});
    wrong[8 + 8] = '\x7f';
    EXPECT_LE(sent(wrong).size(), 2U);
}

TEST(EarlierCalls, AreKnownByPlaceAndTurn) {
    EXPECT_EQ(numberOfCall("a.cpp:1", 2), numberOfCall("a.cpp:1", 2));
    EXPECT_NE(numberOfCall("a.cpp:1", 2), numberOfCall("a.cpp:1", 3));
    EXPECT_NE(numberOfCall("a.cpp:1", 0), numberOfCall("a.cpp:11", 0));
}

}  // namespace
}  // namespace glibra::base
