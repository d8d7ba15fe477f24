// What becomes of pieces of work whose graphics device is reset: by themselves, by another piece, by another
// program.

#include "base/device_lost.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <thread>

#include "base/packed.h"
#include "base/workers.h"
#include "system/process.h"

namespace glibra::base {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using End = Outcome::End;

/// A device that all processes see as a file; each reset adds a byte.
class Device {
  public:
    Device() : file_(fs::temp_directory_path() / ("device-" + std::to_string(system::ownNumber()))) {
        reset();
    }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    ~Device() { fs::remove(file_); }
    void reset() const { std::ofstream(file_, std::ios::app) << 'x'; }
    [[nodiscard]] std::uintmax_t resets() const { return fs::file_size(file_); }

  private:
    fs::path file_;
};

DeviceLost lostBy(ResetCause cause) {
    DeviceLost lost;
    lost.cause = cause;
    lost.place = {"a scene.glib", 3, 1};
    lost.lastLine = 7;
    return lost;
}

struct Ends {
    std::map<std::size_t, Outcome> outcomes;
    std::map<std::size_t, int> repeated;
};

Ends runAllOf(std::size_t count, WorkerOptions options, const Work& work) {
    Ends ends;
    options.repeated = [&](std::size_t index, const Outcome&) { ++ends.repeated[index]; };
    runInWorkers(
        count, options, work,
        [&](std::size_t index, const Outcome& outcome) { ends.outcomes[index] = outcome; },
        [](std::size_t, const std::string&) {});
    return ends;
}

TEST(DeviceLostText, IsReadBackAsItWasWritten) {
    for (const ResetCause cause : {ResetCause::own, ResetCause::other, ResetCause::unknown}) {
        const auto read = unpacked<DeviceLost>(packed(lostBy(cause)));
        ASSERT_TRUE(read);
        EXPECT_EQ(read->cause, cause);
        EXPECT_EQ(read->place, (Place{"a scene.glib", 3, 1}));
        EXPECT_EQ(read->lastLine, 7);
    }
    const std::string right = packed(lostBy(ResetCause::unknown));
    for (std::size_t length = 0; length < right.size(); ++length)
        EXPECT_FALSE(unpacked<DeviceLost>(right.substr(0, length))) << length;
    EXPECT_FALSE(unpacked<DeviceLost>(right + "x"));
    EXPECT_FALSE(unpacked<DeviceLost>(char(right[0] + 1) + right.substr(1))) << "there is no such cause";
}

TEST(DeviceLostText, NamesTheSceneOnlyIfItIsToBlame) {
    EXPECT_EQ(diagnosticOf(lostBy(ResetCause::own), "b.glib").id, "gpu-E06");
    EXPECT_EQ(diagnosticOf(lostBy(ResetCause::unknown), "b.glib").id, "gpu-E06");
    EXPECT_EQ(diagnosticOf(lostBy(ResetCause::other), "b.glib").id, "gpu-E07");
    EXPECT_EQ(diagnosticOf({}, "b.glib").place.file, "b.glib");
    EXPECT_EQ(diagnosticOf(lostBy(ResetCause::own), "b.glib").place.line, 3);
}

/// Piece 2 resets the device; every process that works with it then is lost.
class LostPieces : public testing::TestWithParam<std::tuple<int, ResetCause>> {};

TEST_P(LostPieces, ThePieceThatResetsTheDeviceIsToBlameAndAllOthersAreDone) {
    const int workers = std::get<0>(GetParam());
    const ResetCause told = std::get<1>(GetParam());
    const Device device;
    // Every worker opens the device with its first piece.
    std::uintmax_t opened = 0;
    const auto work = [&](std::size_t index, const Step&) {
        if (opened == 0) opened = device.resets();
        if (index == 2) {
            std::this_thread::sleep_for(30ms);
            device.reset();
            throw lostBy(told);
        }
        std::this_thread::sleep_for(60ms);
        if (device.resets() != opened) throw lostBy(told == ResetCause::own ? ResetCause::other : told);
        return std::to_string(index);
    };
    const Ends ends = runAllOf(8, {.workers = workers, .sharesDevice = true}, work);
    ASSERT_EQ(ends.outcomes.size(), 8U);
    for (const auto& [index, outcome] : ends.outcomes) {
        EXPECT_EQ(outcome.end, index == 2 ? End::deviceLost : End::finished) << index;
        EXPECT_EQ(outcome.answer, index == 2 ? "" : std::to_string(index));
    }
    EXPECT_EQ(ends.outcomes.at(2).lost.place.line, 3);
}

INSTANTIATE_TEST_SUITE_P(Workers, LostPieces,
                         testing::Combine(testing::Values(1, 2, 4),
                                          testing::Values(ResetCause::own, ResetCause::unknown)));

// The driver does not say who is to blame, so whoever is alone is blamed.
TEST(LostDevice, AWorkerThatWasThereBeforeAResetIsNotBlamedForIt) {
    const Device device;
    std::uintmax_t opened = 0;
    const auto work = [&](std::size_t index, const Step& step) {
        if (opened == 0) opened = device.resets();
        if (index == 1) {
            step("");
            device.reset();
            throw lostBy(ResetCause::unknown);
        }
        // Piece 0 sees nothing of the reset. The file of the device begins with one byte.
        while (index == 0 && device.resets() == 1) std::this_thread::sleep_for(1ms);
        if (index == 2 && device.resets() != opened) throw lostBy(ResetCause::unknown);
        return std::to_string(index);
    };
    std::map<std::size_t, Outcome> outcomes;
    runInWorkers(
        3, {.workers = 2}, work,
        [&](std::size_t index, const Outcome& outcome) { outcomes[index] = outcome; },
        // Meanwhile piece 0 is done and piece 1 is lost: the worker of piece 0 gets piece 2, and is alone.
        [](std::size_t, const std::string&) { std::this_thread::sleep_for(300ms); });
    for (const auto& [index, outcome] : outcomes)
        EXPECT_EQ(outcome.end, index == 1 ? End::deviceLost : End::finished) << index;
}

TEST(LostDevice, APieceIsGivenUpWhenOtherProgramsGoOnResettingTheDevice) {
    const Ends ends = runAllOf(2, {.workers = 2}, [](std::size_t index, const Step&) -> std::string {
        if (index == 1) throw lostBy(ResetCause::other);
        return "good";
    });
    EXPECT_EQ(ends.outcomes.at(0).end, End::finished);
    EXPECT_EQ(ends.outcomes.at(1).end, End::deviceLost);
    EXPECT_EQ(ends.repeated.at(1), 3);
}

TEST(LostDevice, APieceThatIsLateBesideOthersOnASharedDeviceIsDoneAgainAlone) {
    for (const bool shares : {false, true}) {
        // The first time another piece holds the device; alone it is quick.
        const Device device;
        const auto work = [&](std::size_t index, const Step&) -> std::string {
            if (index == 1 && device.resets() == 1) {
                device.reset();
                std::this_thread::sleep_for(10s);
            }
            std::this_thread::sleep_for(100ms);
            return "good";
        };
        const Ends ends = runAllOf(2, {.workers = 2, .timeout = .5, .sharesDevice = shares}, work);
        EXPECT_EQ(ends.outcomes.at(0).end, End::finished);
        EXPECT_EQ(ends.outcomes.at(1).end, shares ? End::finished : End::timedOut);
    }
    const Ends ends =
        runAllOf(1, {.timeout = .2, .sharesDevice = true}, [](std::size_t, const Step&) -> std::string {
            std::this_thread::sleep_for(10s);
            return "late";
        });
    EXPECT_EQ(ends.outcomes.at(0).end, End::timedOut) << "it was alone, so nobody else is to blame";
    EXPECT_TRUE(ends.repeated.empty());
}

TEST(LostDevice, TheTimeForWhichAnotherPieceHoldsTheDeviceIsNotCounted) {
    for (const bool shares : {false, true}) {
        const auto work = [](std::size_t index, const Step&) -> std::string {
            std::this_thread::sleep_for(index == 0 ? 400ms : 750ms);
            if (index == 0) throw lostBy(ResetCause::own);
            return "good";
        };
        const Ends ends =
            runAllOf(2, {.workers = 2, .timeout = .6, .sharesDevice = shares, .repeats = false}, work);
        EXPECT_EQ(ends.outcomes.at(0).end, End::deviceLost);
        EXPECT_EQ(ends.outcomes.at(1).end, shares ? End::finished : End::timedOut);
    }
}

TEST(LostDevice, AWorkerThatSaysNonsenseOfADeviceIsOneThatCrashed) {
    const Ends ends = runAllOf(1, {}, [](std::size_t, const Step&) -> std::string {
        DeviceLost lost;
        lost.cause = static_cast<ResetCause>(9);
        throw lost;
    });
    EXPECT_EQ(ends.outcomes.at(0).end, End::crashed);
}

}  // namespace
}  // namespace glibra::base
