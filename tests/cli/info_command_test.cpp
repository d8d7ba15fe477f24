// glibra info: the driver, and the precision of its functions.

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

TEST(InfoCommand, TellsThePrecisionOfEveryFunctionAsJson) {
    const Folder folder;
    const Finished finished = glibra(folder.path(), "info --precision --json");
    ASSERT_EQ(finished.status, 0) << finished.err;
    const auto json = nlohmann::json::parse(finished.out);
    bool hasDivision = false, hasSine = false;
    for (const auto& row : json.at("precision")) {
        const std::string function = row.at("function");
        for (const char* stage : {"vertex", "fragment"}) {
            EXPECT_GT(row.at(stage).at("samples").get<int>(), 1000) << function;
            EXPECT_GE(row.at(stage).at("meanUlp").get<double>(), 0) << function;
        }
        if (function == "division") {
            hasDivision = true;
            EXPECT_EQ(row.at("bound"), "2.5 ULP");
            EXPECT_TRUE(row.at("fragment").contains("timesTheBound"));
        }
        if (function == "sin") {
            hasSine = true;
            EXPECT_FALSE(row.at("fragment").contains("timesTheBound"));
        }
    }
    EXPECT_TRUE(hasDivision && hasSine);
}

TEST(InfoCommand, TellsWhichBoundsAreBrokenInWords) {
    const Folder folder;
    const Finished finished = glibra(folder.path(), "info --precision");
    ASSERT_EQ(finished.status, 0) << finished.err;
    EXPECT_NE(finished.out.find("inversesqrt"), std::string::npos);
    EXPECT_NE(finished.out.find("bounds are broken"), std::string::npos);
}

}  // namespace
}  // namespace glibra::test
