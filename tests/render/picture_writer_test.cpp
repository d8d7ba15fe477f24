// Several threads write frames while others are drawn.

#include "render/file/picture_writer.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "image/file.h"
#include "image/png/png_reader.h"

namespace glibra::render {
namespace {

namespace fs = std::filesystem;

class PictureWriterTest : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    [[nodiscard]] fs::path file(int index) const { return folder / (std::to_string(index) + ".png"); }

    const fs::path folder =
        fs::path(testing::TempDir()) /
        ("glibra-writer-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

/// A picture large enough that encoding takes longer than making it.
image::Image picture(int shade) {
    image::Image made{300, 200, 3, image::Component::u8, {}};
    made.data.assign(made.rowBytes() * 200, static_cast<std::byte>(shade));
    return made;
}

int shadeOf(const fs::path& path) {
    const auto bytes = image::readFile(path, {path.string(), {}});
    if (!bytes) return -1;
    const auto read = image::decodePng(*bytes, {path.string(), {}});
    return read ? std::to_integer<int>(read->data.at(0)) : -2;
}

TEST_F(PictureWriterTest, EveryFrameIsInItsFile) {
    for (const std::size_t threads : {1U, 2U, 8U}) {
        std::vector<int> counts;
        const std::function<void(int)> written = [&](int count) { counts.push_back(count); };
        PictureWriter writer(written, threads);
        for (int i = 0; i < 60; ++i) {
            // Every third frame is a copy of the one before, which may not be written yet.
            const bool added =
                i % 3 == 2 ? writer.addCopy(file(i - 1), file(i)) : writer.add(picture(i), file(i));
            ASSERT_TRUE(added);
        }
        EXPECT_TRUE(writer.finish().empty());
        ASSERT_EQ(counts.size(), 60U);
        for (int i = 0; i < 60; ++i) {
            EXPECT_EQ(counts[static_cast<std::size_t>(i)], i + 1);
            EXPECT_EQ(shadeOf(file(i)), i % 3 == 2 ? i - 1 : i);
            fs::remove(file(i));
        }
    }
}

TEST_F(PictureWriterTest, AFileThatCannotBeWrittenEndsItWithOneError) {
    const std::function<void(int)> written = [](int) {};
    PictureWriter writer(written, 4);
    bool goesOn = true;
    for (int i = 0; i < 1000 && goesOn; ++i)
        goesOn = writer.add(picture(1), folder / "missing" / "frame.png");
    EXPECT_FALSE(goesOn);
    const Diagnostics problems = writer.finish();
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems.front().id, "file-E10");
}

TEST_F(PictureWriterTest, ACopyOfWhatFailedEndsToo) {
    const std::function<void(int)> written = [](int) {};
    PictureWriter writer(written, 4);
    const fs::path nowhere = folder / "missing" / "frame.png";
    if (writer.add(picture(1), nowhere)) writer.addCopy(nowhere, file(1));
    EXPECT_EQ(writer.finish().size(), 1U);
    EXPECT_FALSE(fs::exists(file(1)));
}

}  // namespace
}  // namespace glibra::render
