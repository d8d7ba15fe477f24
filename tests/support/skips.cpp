// With GLIBRA_NO_SKIPS set, as by tools/test, a test that skips itself fails, unless tests/skips.txt names
// it.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

namespace glibra::test {
namespace {

/// The first word of each line that is not a comment.
std::set<std::string> allowedSkips() {
    std::set<std::string> names;
    std::ifstream file(GLIBRA_SOURCE_DIR "/tests/skips.txt");
    for (std::string line; std::getline(file, line);)
        if (!line.empty() && line.front() != '#') names.insert(line.substr(0, line.find(' ')));
    return names;
}

class SkipsFail : public testing::EmptyTestEventListener {
    void OnTestEnd(const testing::TestInfo& test) override {
        if (!test.result()->Skipped()) return;
        const std::string name = std::string(test.test_suite_name()) + "." + test.name();
        EXPECT_TRUE(allowed_.contains(name))
            << name << " was skipped; tests/skips.txt names those that may be";
    }
    std::set<std::string> allowed_ = allowedSkips();
};

[[maybe_unused]] const bool kIsAdded = [] {
    if (std::getenv("GLIBRA_NO_SKIPS") != nullptr)
        testing::UnitTest::GetInstance()->listeners().Append(new SkipsFail);  // which owns it
    return true;
}();

}  // namespace
}  // namespace glibra::test
