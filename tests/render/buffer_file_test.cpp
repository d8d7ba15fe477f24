// What --save writes of buffers.

#include "render/file/buffer_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <sstream>

#include "modern_text.h"
#include "render/file/job.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

class BufferFile : public testing::Test {
  protected:
    void SetUp() override {
        if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    }

    static std::string contentOf(const std::filesystem::path& file) {
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        return text.str();
    }

    /// The files of a picture, by their names, and the messages.
    static std::map<std::string, std::string> saved(const SceneFolder& folder,
                                                    const std::map<std::string, std::string>& files) {
        render::Job job;
        job.scene = folder / "scene.glib";
        job.output = folder / "out.png";
        for (const auto& [object, file] : files) job.saves.push_back({object, folder / file});
        const render::JobResult result = render::runJob(sharedContext(), job, [](int) {});
        std::map<std::string, std::string> contents{{"messages", text(result.diagnostics)}};
        for (const auto& [object, file] : files)
            if (std::filesystem::exists(folder / file)) contents[file] = contentOf(folder / file);
        return contents;
    }
};

/// A head, and elements with padding.
const std::string kPoints =
    "WindowSize 4 4\nBuffer Points 2\nCompute inline\n#version 430 core\nlayout(local_size_x = 2) in;\n"
    "struct Point { vec3 at; int id; bool on; uint marks[2]; };\n"
    "layout(std430) buffer Points { float scale; Point points[]; };\nvoid main() {\n"
    "  uint i = gl_GlobalInvocationID.x;\n  if (i == 0u) scale = .1;\n"
    "  points[i].at = vec3(i, -1.5, 1. / 3.);\n  points[i].id = -int(i) - 1;\n  points[i].on = i == 1u;\n"
    "  points[i].marks[0] = 4294967295u;\n  points[i].marks[1] = i;\n}\nEndCompute\nProgram Set\n"
    "Dispatch Set 1\n";

TEST_F(BufferFile, HasAFieldForEachMemberAndARecordForEachElement) {
    const SceneFolder folder(kPoints);
    const auto files = saved(folder, {{"Points", "points.csv"}});
    EXPECT_EQ(files.at("points.csv"),
              "scale,at.x,at.y,at.z,id,on,marks[0],marks[1]\n"
              "0.1,0,-1.5,0.33333334,-1,0,4294967295,0\n"
              "0.1,1,-1.5,0.33333334,-2,1,4294967295,1\n");
}

TEST_F(BufferFile, OfNumPyHoldsTheNumbersAsTheyAre) {
    const SceneFolder folder(kPoints);
    const std::string file = saved(folder, {{"Points", "points.npy"}}).at("points.npy");
    ASSERT_TRUE(file.starts_with("\x93NUMPY\x01"));
    const std::size_t length =
        static_cast<unsigned char>(file[8]) + 256U * static_cast<unsigned char>(file[9]);
    EXPECT_EQ((10 + length) % 64, 0U);
    const std::string header = file.substr(10, length);
    EXPECT_EQ(header.substr(0, header.find('}')),
              "{'descr': [('scale', '<f4'), ('at', '<f4', (3,)), ('id', '<i4'), ('on', '|b1'), "
              "('marks[0]', '<u4'), ('marks[1]', '<u4'), ], 'fortran_order': False, 'shape': (2,), ");
    EXPECT_TRUE(header.ends_with("\n"));
    const std::string data = file.substr(10 + length);
    constexpr std::size_t kRecord = 4 + 12 + 4 + 1 + 8;
    ASSERT_EQ(data.size(), 2 * kRecord);
    float scale = 0, third = 0;
    std::memcpy(&scale, data.data() + kRecord, 4);
    std::memcpy(&third, data.data() + kRecord + 12, 4);
    EXPECT_EQ(scale, .1F);
    EXPECT_EQ(third, 1.F / 3);
    EXPECT_EQ(data[20], 0);
    EXPECT_EQ(data[kRecord + 20], 1);
}

TEST_F(BufferFile, IsWrittenForBuffersThatThePictureDoesNotShow) {
    const SceneFolder folder(
        "WindowSize 4 4\nBuffer Level float [1 2.5 3]\nBuffer Other float 2\nCompute inline\n#version 430 "
        "core\n"
        "layout(local_size_x = 1) in;\nlayout(std430) buffer Level { float levels[]; };\n"
        "void main() { levels[1] *= 2.; }\nEndCompute\nProgram Twice\nDispatch Twice 1\n");
    const auto files = saved(folder, {{"Level", "level.csv"}, {"Other", "other.csv"}});
    EXPECT_EQ(files.at("level.csv"), "levels\n1\n5\n3\n");
    EXPECT_EQ(files.at("other.csv"), "value\n0\n0\n");
}

TEST_F(BufferFile, NeedsAKnownNameAndSuffix) {
    const SceneFolder folder(kPoints);
    const auto message = [&](const char* object, const char* file) {
        const auto files = saved(folder, {{object, file}});
        EXPECT_EQ(files.size(), 1U) << "no file";
        return files.at("messages");
    };
    EXPECT_NE(message("Point", "a.csv").find("no texture or buffer of that name; did you mean 'Points'?"),
              std::string::npos)
        << message("Point", "a.csv");
    EXPECT_NE(message("Points.level(1)", "a.csv").find("only .prev may stand"), std::string::npos);
    EXPECT_NE(message("Points.prev", "a.csv").find("declared without history"), std::string::npos);
    EXPECT_NE(message("Points", "a.png").find("buffers are written as .csv or .npy"), std::string::npos);
}

}  // namespace
}  // namespace glibra::test
