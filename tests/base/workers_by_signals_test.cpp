// Workers that write into each other's pipes, get signals, or are refused memory: by the calls of POSIX.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>

#include "worker_log.h"

namespace glibra::base {
namespace {

/// Writes bytes to every pipe of this process, as code can that a shader has brought in.
void writeToPipes(const std::string& bytes) {
    for (int file = 3; file < 64; ++file) {
        struct stat status{};
        if (::fstat(file, &status) == 0 && S_ISFIFO(status.st_mode))
            static_cast<void>(::write(file, bytes.data(), bytes.size()));
    }
}

TEST(WorkersBySignals, AMessageThatStopsInItsMiddleHoldsUpNobody) {
    const Log log =
        runAll(5, {.workers = 2, .timeout = 0.3}, [](std::size_t index, const Step&) -> std::string {
            if (index == 1) {
                writeToPipes("abc");
                for (;;) ::pause();
            }
            return "good";
        });
    for (const auto& [index, outcome] : log.outcomes)
        EXPECT_EQ(outcome.end, index == 1 ? Outcome::End::timedOut : Outcome::End::finished) << index;
}

TEST(WorkersBySignals, AMessageThatIsNoneEndsItsWorker) {
    for (const std::string& message :
         {std::string("\xff\xff\xff\xff\1\0\0\0", 8), std::string("\0\0\0\0\xff\xff\xff\xff", 8)}) {
        const Log log = runAll(5, {.workers = 2}, [&](std::size_t index, const Step&) -> std::string {
            if (index == 1) {
                writeToPipes(message);
                for (;;) ::pause();
            }
            return "good";
        });
        for (const auto& [index, outcome] : log.outcomes)
            EXPECT_EQ(outcome.end, index == 1 ? Outcome::End::crashed : Outcome::End::finished) << index;
    }
}

TEST(WorkersBySignals, PassOverTheSignalsOfATerminal) {
    const Log log = runAll(1, {.workers = 1}, [](std::size_t, const Step&) {
        ::raise(SIGINT);
        ::raise(SIGHUP);
        return std::string("alive");
    });
    EXPECT_EQ(log.outcomes.at(0).answer, "alive");
}

TEST(WorkersBySignals, EveryPieceMayHaveALimitOfMemoryOfItsOwn) {
    constexpr std::uint64_t kMuch = std::uint64_t{1} << 30;
    const Log log = runAll(
        3, {.workers = 1, .memoryOf = [](std::size_t index) { return index == 1 ? kMuch / 4 : 2 * kMuch; }},
        [](std::size_t, const Step&) {
            void* got = ::mmap(nullptr, kMuch, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            if (got == MAP_FAILED) return std::string("refused");
            ::munmap(got, kMuch);
            return std::string("given");
        });
    EXPECT_EQ(log.outcomes.at(0).answer, "given");
    EXPECT_EQ(log.outcomes.at(1).answer, "refused");
    EXPECT_EQ(log.outcomes.at(2).answer, "given");
}

}  // namespace
}  // namespace glibra::base
