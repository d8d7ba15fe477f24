// glibra info: the driver. bench_test.cpp tests its --precision.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "program.h"

namespace glibra::test {
namespace {

TEST(InfoCommand, NamesTheDriverWithoutMeasuringIt) {
    const Folder folder;
    const Finished finished = glibra(folder.path(), "info --json");
    ASSERT_EQ(finished.status, 0) << finished.err;
    const auto json = nlohmann::json::parse(finished.out);
    EXPECT_FALSE(json.at("renderer").get<std::string>().empty());
    EXPECT_FALSE(json.contains("precision"));
}

}  // namespace
}  // namespace glibra::test
