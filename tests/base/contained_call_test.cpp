#include "base/contained_call.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <future>
#include <memory>
#include <vector>

#include "system/memory.h"

namespace glibra::base {
namespace {

using Kind = CallEnd::Kind;

TEST(ContainedCall, ReturnsItsResultInSharedMemoryAndNothingElse) {
    const system::SharedMemory shared(16);
    ASSERT_EQ(shared.bytes().size(), 16U);
    int own = 1;
    const CallEnd end = runContained({}, [&] {
        shared.bytes()[3] = std::byte{42};
        own = 2;
    });
    EXPECT_EQ(end.kind, Kind::finished);
    EXPECT_EQ(shared.bytes()[3], std::byte{42});
    EXPECT_EQ(own, 1);
}

TEST(ContainedCall, EndsWorkThatWaitsOrComputesForEver) {
    EXPECT_EQ(runContained({.seconds = .2},
                           [] {
                               for (;;) ::pause();
                           })
                  .kind,
              Kind::timedOut);
    EXPECT_EQ(runContained({.seconds = .2},
                           [] {
                               for (std::atomic<unsigned> i = 0;;) ++i;
                           })
                  .kind,
              Kind::timedOut);
}

TEST(ContainedCall, ReportsHowTheProcessDied) {
    const CallEnd killed = runContained({}, [] { ::raise(SIGKILL); });
    EXPECT_EQ(killed.kind, Kind::died);
    EXPECT_EQ(killed.signal, SIGKILL);
    const CallEnd left = runContained({}, [] { ::_exit(3); });
    EXPECT_EQ(left.kind, Kind::died);
    EXPECT_EQ(left.signal, 0);
}

TEST(ContainedCall, HasALimitOfMemory) {
    constexpr std::size_t kMuch = std::size_t{1} << 30;
    const system::SharedMemory shared(2);
    const auto allocates = [&](std::uint64_t limit) {
        shared.bytes()[0] = std::byte{0};
        const CallEnd end = runContained({.memory = limit}, [&] {
            const void* got =
                ::mmap(nullptr, kMuch, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            shared.bytes()[0] = std::byte{got == MAP_FAILED ? std::uint8_t{1} : std::uint8_t{2}};
        });
        EXPECT_EQ(end.kind, Kind::finished);
        return shared.bytes()[0];
    };
    EXPECT_EQ(allocates(kMuch / 4), std::byte{1});
    EXPECT_EQ(allocates(kMuch * 2), std::byte{2});
    EXPECT_EQ(allocates(0), std::byte{2});
}

TEST(ContainedCall, RunsFromSeveralThreadsAtOnce) {
    std::vector<std::future<CallEnd>> all;
    for (int i = 0; i < 8; ++i)
        all.push_back(std::async(std::launch::async, [i] {
            return runContained({.seconds = 30}, [i] {
                if (i % 2 == 1) ::raise(SIGKILL);
            });
        }));
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_EQ(all[i].get().kind, i % 2 == 1 ? Kind::died : Kind::finished) << i;
}

TEST(ContainedCall, KeepsALowerLimitOfMemoryOfItsCaller) {
    const CallEnd end = runContained({.seconds = 10, .memory = std::uint64_t{64} << 20}, [] {
        const CallEnd inner = runContained({.seconds = 10}, [] {
            void* const got = ::mmap(nullptr, std::size_t{256} << 20, PROT_READ | PROT_WRITE,
                                     MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            if (got != MAP_FAILED) ::_exit(1);
        });
        if (inner.kind != Kind::finished) ::_exit(1);
    });
    EXPECT_EQ(end.kind, Kind::finished);
}

TEST(CallInThread, IsGivenUpAfterItsTime) {
    const auto value = std::make_shared<std::atomic<int>>(0);
    EXPECT_TRUE(runInThread({.seconds = 30}, [value] { *value = 7; }));
    EXPECT_EQ(*value, 7);
    EXPECT_TRUE(runInThread({.seconds = 0}, [value] { *value = 8; })) << "no limit";
    EXPECT_EQ(*value, 8);
    const auto go = std::make_shared<std::promise<void>>();
    EXPECT_FALSE(runInThread({.seconds = .02}, [go] { go->get_future().wait(); }));
    go->set_value();
}

TEST(MemoryShare, IsDividedAmongTheWorkersButNeverTooSmall) {
    EXPECT_GE(memoryShare(1, 9), memoryShare(2, 9));
    EXPECT_EQ(memoryShare(64, 1), memoryShare(1, 9)) << "one piece has one worker";
    EXPECT_EQ(memoryShare(1'000'000, 1'000'000), kLeastShare);
}

}  // namespace
}  // namespace glibra::base
