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

TEST(InfoCommand, HasTheLimitsOfComputeAndControlStages) {
    const Folder folder;
    const auto json = nlohmann::json::parse(glibra(folder.path(), "info --json").out);
    // OpenGL 4.3 core specification, tables 23.55 to 23.60.
    ASSERT_TRUE(json.at("compute").get<bool>());
    for (const char* axis : {"X", "Y", "Z"})
        EXPECT_GE(json.at(std::string("maxComputeGroups") + axis).get<int>(), 65535) << axis;
    EXPECT_GE(json.at("maxComputeLocalSizeX").get<int>(), 1024);
    EXPECT_GE(json.at("maxComputeLocalSizeZ").get<int>(), 64);
    EXPECT_GE(json.at("maxComputeInvocations").get<int>(), 1024);
    EXPECT_GE(json.at("maxComputeSharedBytes").get<int>(), 32768);
    EXPECT_GE(json.at("maxStorageBufferBindings").get<int>(), 8);
    EXPECT_GE(json.at("maxStorageBlockBytes").get<long long>(), 1LL << 24);
    EXPECT_GE(json.at("maxControlInputComponents").get<int>(), 128);
    EXPECT_GE(json.at("maxControlOutputComponents").get<int>(), 128);
    EXPECT_GE(json.at("maxControlPatchComponents").get<int>(), 120);
    EXPECT_GE(json.at("maxControlTotalOutputComponents").get<int>(), 2048);
    EXPECT_GE(json.at("maxEvaluationInputComponents").get<int>(), 128);
}

}  // namespace
}  // namespace glibra::test
