#include "bench/core/bench.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <future>
#include <memory>
#include <thread>

#include "gpu/context/context.h"
#include "system/places.h"
#include "system/process.h"

namespace glibra::bench {
namespace {

std::string settingOf(const std::string& name) {
    const char* before = std::getenv(name.c_str());
    const std::string found = before ? before : "unset";
    system::setVariable(name.c_str(), "changed", system::Replace::yes);
    return found + " in " + std::to_string(system::ownNumber());
}

std::string large(const std::string& request) {
    return std::string(1 << 20, 'x') + request;
}

std::string crash(const std::string&) {
    std::abort();
}

/// Needs a process into which no earlier test has loaded a driver: --gtest_filter='ApartFromTheStart.*'
class ApartFromTheStart : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(Apart().run(settingOf, "GLIBRA_TEST_SETTING"))
            << "does this process have a driver already?";
    }
};

TEST_F(ApartFromTheStart, EveryPieceOfWorkHasAFreshProcess) {
    Apart apart;
    const std::optional<std::string> first = apart.run(settingOf, "GLIBRA_TEST_SETTING");
    const std::optional<std::string> second = apart.run(settingOf, "GLIBRA_TEST_SETTING");
    ASSERT_TRUE(first && second);
    EXPECT_TRUE(first->starts_with("unset in "));
    EXPECT_TRUE(second->starts_with("unset in "));
    EXPECT_NE(*first, *second);
    EXPECT_NE(*first, "unset in " + std::to_string(system::ownNumber()));
}

TEST_F(ApartFromTheStart, AnswersLargerThanAPipeArrive) {
    Apart apart;
    EXPECT_EQ(apart.run(large, "end"), std::string(1 << 20, 'x') + "end");
}

TEST_F(ApartFromTheStart, ACrashGivesNoAnswerAndTheNextPieceIsDone) {
    Apart apart;
    EXPECT_FALSE(apart.run(crash, ""));
    EXPECT_EQ(apart.run(large, ""), std::string(1 << 20, 'x'));
}

TEST_F(ApartFromTheStart, TheFirstOfTwoEndsWhileTheSecondLives) {
    auto first = std::make_unique<Apart>();
    Apart second;
    first.reset();
    EXPECT_TRUE(second.run(large, ""));
}

TEST(Apart, WithSeveralThreadsThereIsNoAnswerAndNoHang) {
    std::promise<void> end;
    std::thread other([&end] { end.get_future().wait(); });
    Apart apart;
    EXPECT_FALSE(apart.run(large, ""));
    end.set_value();
    other.join();
}

TEST(Apart, OnceADriverIsLoadedThereIsNoAnswerAndNoHang) {
    const Result<gpu::Context> context = gpu::openContext();
    if (!context) GTEST_SKIP() << "no driver";
    Apart apart;
    EXPECT_FALSE(apart.run(large, ""));
}

}  // namespace
}  // namespace glibra::bench
