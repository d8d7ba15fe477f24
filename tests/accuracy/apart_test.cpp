#include "bench/apart.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>

namespace glibra::bench {
namespace {

std::string settingOf(const std::string& name) {
    const char* before = std::getenv(name.c_str());
    const std::string found = before ? before : "unset";
    setenv(name.c_str(), "changed", 1);
    return found + " in " + std::to_string(getpid());
}

std::string large(const std::string& request) {
    return std::string(1 << 20, 'x') + request;
}

std::string crash(const std::string&) {
    std::abort();
}

TEST(Apart, EveryPieceOfWorkHasAFreshProcess) {
    Apart apart;
    const std::optional<std::string> first = apart.run(settingOf, "GLIBRA_TEST_SETTING");
    const std::optional<std::string> second = apart.run(settingOf, "GLIBRA_TEST_SETTING");
    ASSERT_TRUE(first && second);
    EXPECT_TRUE(first->starts_with("unset in "));
    EXPECT_TRUE(second->starts_with("unset in "));
    EXPECT_NE(*first, *second);
    EXPECT_NE(*first, "unset in " + std::to_string(getpid()));
}

TEST(Apart, AnswersLargerThanAPipeArrive) {
    Apart apart;
    EXPECT_EQ(apart.run(large, "end"), std::string(1 << 20, 'x') + "end");
}

TEST(Apart, ACrashIsNoAnswerAndTheNextPieceIsDone) {
    Apart apart;
    EXPECT_FALSE(apart.run(crash, ""));
    EXPECT_EQ(apart.run(large, ""), std::string(1 << 20, 'x'));
}

TEST(Apart, TheFirstOfTwoEndsWhileTheSecondLives) {
    auto first = std::make_unique<Apart>();
    Apart second;
    first.reset();
    EXPECT_TRUE(second.run(large, ""));
}

}  // namespace
}  // namespace glibra::bench
