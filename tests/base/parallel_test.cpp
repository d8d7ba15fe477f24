#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace glibra::base {
namespace {

TEST(Parallel, EveryIndexIsVisitedOnce) {
    for (const int threads : {0, 1, 2, 7, 100})
        for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
            std::vector<std::atomic<int>> visits(count);
            forEachIndex(count, threads, [&](std::size_t index) { ++visits[index]; });
            for (const std::atomic<int>& each : visits) EXPECT_EQ(each, 1);
        }
}

TEST(Parallel, AStateBelongsToOneThread) {
    std::mutex mutex;
    std::set<std::thread::id> makers;
    std::atomic<int> sum = 0;
    forEachIndex(
        100, 4,
        [&] {
            const std::scoped_lock lock(mutex);
            EXPECT_TRUE(makers.insert(std::this_thread::get_id()).second);
            return std::this_thread::get_id();
        },
        [&](std::size_t, const std::thread::id& maker) {
            EXPECT_EQ(maker, std::this_thread::get_id());
            ++sum;
        });
    EXPECT_EQ(sum, 100);
    EXPECT_LE(makers.size(), 4U);
}

TEST(Parallel, AnExceptionOnAnyThreadReachesTheCaller) {
    for (const int threads : {1, 4})
        for (const std::size_t bad : {0U, 7U, 99U}) {
            EXPECT_THROW(forEachIndex(100, threads,
                                      [&](std::size_t index) {
                                          if (index == bad) throw std::bad_alloc();
                                      }),
                         std::bad_alloc);
        }
    EXPECT_THROW(forEachIndex(
                     3, 2, []() -> int { throw std::runtime_error("no state"); }, [](std::size_t, int) {}),
                 std::runtime_error);
}

TEST(Parallel, NoIndexBeginsAfterAnException) {
    int visits = 0;
    EXPECT_THROW(forEachIndex(100, 1,
                              [&](std::size_t index) {
                                  ++visits;
                                  if (index == 3) throw std::runtime_error("stop");
                              }),
                 std::runtime_error);
    EXPECT_EQ(visits, 4);
}

}  // namespace
}  // namespace glibra::base
