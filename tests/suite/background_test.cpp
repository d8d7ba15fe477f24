#include "suite/run/shot_renderer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <new>
#include <stdexcept>
#include <vector>

namespace glibra::suite {
namespace {

using namespace std::chrono_literals;

/// Blocks a job that passes through it until it is opened.
class Gate {
  public:
    void pass() const { opened_.wait(); }
    void open() { open_.set_value(); }

  private:
    std::promise<void> open_;
    std::shared_future<void> opened_ = open_.get_future().share();
};

bool isHeldBack(std::future<void>& adding) {
    return adding.wait_for(30ms) == std::future_status::timeout;
}

TEST(Background, DoesJobsInOrderAndAllOfThem) {
    std::vector<int> done;
    {
        Background background;
        for (int i = 0; i < 100; ++i) background.add([&done, i] { done.push_back(i); });
    }
    ASSERT_EQ(done.size(), 100U);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(Background, WaitsForOneJobWithoutTheNext) {
    Gate gate;
    std::atomic<int> done = 0;
    Background background;
    const std::uint64_t first = background.add([&] { done = 1; });
    background.add([&] {
        gate.pass();
        done = 2;
    });
    background.wait(first);
    EXPECT_EQ(done, 1);
    gate.open();
    background.wait();
    EXPECT_EQ(done, 2);
}

TEST(Background, HoldsBackWhatIsTooMuchToWait) {
    struct Case {
        int before;
        std::size_t bytes;
        const char* what;
    };
    for (const Case& each : {Case{1, std::size_t{64} << 20U, "bytes"}, Case{16, 0, "jobs"}}) {
        Gate gate, started;
        std::atomic<int> done = 0;
        Background background;
        background.add([&] {
            started.open();
            gate.pass();
        });
        started.pass();
        for (int i = 0; i < each.before; ++i) background.add([&] { ++done; }, each.bytes);
        std::future<void> adding =
            std::async(std::launch::async, [&] { background.add([&] { ++done; }, 1); });
        EXPECT_TRUE(isHeldBack(adding)) << each.what;
        gate.open();
        adding.wait();
        background.wait();
        EXPECT_EQ(done, each.before + 1) << each.what;
    }
}

TEST(Background, TakesAJobOfAnySizeWhereNoneWaits) {
    Background background;
    bool isDone = false;
    background.add([&] { isDone = true; }, std::size_t{1} << 40U);
    background.wait();
    EXPECT_TRUE(isDone);
}

TEST(Background, PassesOnTheFirstExceptionAndDoesTheOtherJobs) {
    Background background;
    int done = 0;
    background.add([] { throw std::bad_alloc(); });
    background.add([] { throw std::runtime_error("later"); });
    background.add([&] { ++done; });
    EXPECT_THROW(background.wait(), std::bad_alloc);
    EXPECT_EQ(done, 1);
    background.add([&] { ++done; });
    background.finish();
    EXPECT_EQ(done, 2);
    EXPECT_NO_THROW({
        Background forgotten;
        forgotten.add([] { throw std::bad_alloc(); });
    });
}

}  // namespace
}  // namespace glibra::suite
