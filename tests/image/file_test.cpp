// Whole files: read with limits, and written so that nobody sees an incomplete one.

#include "image/file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "image/compare/compare.h"
#include "image/format.h"
#include "image/write.h"
#include "support.h"
#include "system/process.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;
using testing::idsOf;

const FileLabel kFileLabel{"a", {"scene.glib", 3, 1}};

class WholeFile : public testing::InFolder {};

TEST_F(WholeFile, IsReadByteForByte) {
    const auto bytes = testing::noisyImage(33, 7, 3, Component::u8).data;
    const auto read = readFile(put("a", bytes), kFileLabel);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, bytes);
}

TEST_F(WholeFile, DifferentProblemsOfReadingHaveDifferentIds) {
    EXPECT_EQ(idsOf(readFile(folder / "none", kFileLabel).diagnostics), "file-E01");
    EXPECT_EQ(idsOf(readFile(put("empty", {}), kFileLabel).diagnostics), "file-E02");
    const auto inFolder = readFile(folder, kFileLabel);
    ASSERT_EQ(idsOf(inFolder.diagnostics), "file-E14");
    EXPECT_EQ(inFolder.diagnostics[0].text, "cannot read 'a': it is a folder");
    EXPECT_EQ(inFolder.diagnostics[0].place, kFileLabel.place);
    EXPECT_EQ(idsOf(readFile(put("file", testing::bytesOf({1})) / "inside", kFileLabel).diagnostics),
              "file-E01");
}

TEST_F(WholeFile, BeyondTheLimitIsRejectedBeforeReading) {
    put("large", testing::bytesOf({1, 2, 3, 4}));
    EXPECT_TRUE(readFile(folder / "large", kFileLabel, 4));
    EXPECT_EQ(idsOf(readFile(folder / "large", kFileLabel, 3).diagnostics), "file-E09");
    fs::resize_file(folder / "large", 3 * kGiB);  // needs no space on the disk
    const auto read = readFile(folder / "large", kFileLabel);
    ASSERT_EQ(idsOf(read.diagnostics), "file-E09");
    EXPECT_EQ(read.diagnostics[0].text, "'a' has 3 GiB, the limit is 2 GiB");
}

TEST_F(WholeFile, IsWrittenUnderItsNameOnly) {
    const auto bytes = testing::bytesOf({1, 2, 3});
    EXPECT_TRUE(writeFileAtomically(folder / "out.png", bytes).empty());
    EXPECT_EQ(*readFile(folder / "out.png", kFileLabel), bytes);
    const auto longer = testing::bytesOf({4, 5, 6, 7});
    EXPECT_TRUE(writeFileAtomically(folder / "out.png", longer).empty());
    EXPECT_EQ(*readFile(folder / "out.png", kFileLabel), longer);
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(WholeFile, KeepsAllItsNamesIfTheUserNamedIt) {
    const fs::path file = put("a", testing::bytesOf({1, 2, 3}));
    fs::create_hard_link(file, folder / "b");
    EXPECT_TRUE(writeFileAtomically(file, testing::bytesOf({4, 5})).empty());
    EXPECT_EQ(*readFile(folder / "b", kFileLabel), testing::bytesOf({4, 5}));
    TemporaryFile temporary(file);
    ASSERT_EQ(writeAll(temporary.file(), std::string_view("long")), 0);
    EXPECT_TRUE(temporary.commit().empty());
    EXPECT_EQ(*readFile(folder / "b", kFileLabel), testing::bytesOf({'l', 'o', 'n', 'g'}));
    EXPECT_EQ(fileCount(), 2U);
    // The other name is not the program's to change.
    EXPECT_TRUE(writeFileAtomically(file, testing::bytesOf({6}), NamedBy::program).empty());
    EXPECT_EQ(readFile(folder / "b", kFileLabel)->size(), 4U);
}

TEST_F(WholeFile, ALongNameIsNoObstacle) {
    EXPECT_TRUE(
        writeFileAtomically(folder / (std::string(250, 'n') + ".png"), testing::bytesOf({1})).empty());
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(WholeFile, OfAProcessThatIsNoMoreIsRemovedLater) {
    using To = system::Stream::To;
    system::Process child =
        system::startAgain({"tests", "--gtest_list_tests"}, {To::nothing, To::nothing, To::nothing});
    ASSERT_TRUE(child);
    const std::string dead = ".glibra-" + std::to_string(child.number()),
                      own = ".glibra-" + std::to_string(system::ownNumber());
    system::waitFor(child);
    const auto put = [&](const std::string& name, bool isOld) {
        std::ofstream(folder / name) << "half";
        if (isOld)
            fs::last_write_time(folder / name, fs::file_time_type::clock::now() - std::chrono::minutes(5));
    };
    const std::vector<std::string> kept{
        dead + "-1.tmp", own + "-0.tmp", dead + "-golden.png", ".glibra-x-0.tmp", dead + "-0.txt",
        ".glibra-",      "a.tmp"};
    for (const std::string& each : kept) put(each, each != kept.front());
    for (const char* each : {"-0.tmp", "-7.tmp.tif"}) put(dead + each, true);
    const auto folderOf = [&](const std::string& name, int hours) {
        fs::create_directories(folder / name / "0");
        std::ofstream(folder / name / "0/a_0000.png") << "half";
        fs::last_write_time(folder / name, fs::file_time_type::clock::now() - std::chrono::hours(hours));
    };
    folderOf(dead + std::string(kStaging), 30);
    folderOf(dead + std::string(kStaging) + "-1", 1);
    folderOf(own + std::string(kStaging), 30);
    folderOf(dead + "-2.tmp", 30);
    removeAbandonedFiles(folder);
    EXPECT_FALSE(fs::exists(folder / (dead + std::string(kStaging))));
    for (const std::string& each :
         {dead + std::string(kStaging) + "-1", own + std::string(kStaging), dead + "-2.tmp"})
        EXPECT_EQ(fs::remove_all(folder / each), 3U) << each;
    EXPECT_EQ(fileCount(), kept.size());
    for (const std::string& each : kept) EXPECT_TRUE(fs::exists(folder / each)) << each;
}

TEST_F(WholeFile, ThatCannotBeWrittenLeavesNothing) {
    const auto bytes = testing::bytesOf({1, 2, 3});
    const auto missing = writeFileAtomically(folder / "none" / "out.png", bytes);
    ASSERT_EQ(idsOf(missing), "file-E10");
    EXPECT_EQ(missing[0].text, "cannot write '" + (folder / "none" / "out.png").generic_string() +
                                   "': no such file or directory");
    EXPECT_EQ(idsOf(writeFileAtomically(folder, bytes)), "file-E10");
    put("file", bytes);
    EXPECT_EQ(idsOf(writeFileAtomically(folder / "file" / "out.png", bytes)), "file-E10");
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(WholeFile, ATemporaryFileIsRemovedWithoutCommit) {
    {
        const TemporaryFile temporary(folder / "out.exr");
        EXPECT_EQ(temporary.path().extension(), ".exr");
        EXPECT_EQ(fileCount(), 1U);
    }
    EXPECT_EQ(fileCount(), 0U);
}

class WriteImage : public testing::InFolder {};

TEST_F(WriteImage, PngNeedsNoModule) {
    const Image image = testing::noisyImage(9, 8, 4, Component::u8);
    EXPECT_TRUE(writeImage(image, folder / "a.PNG", {{}, {}}).empty());
    const auto read = readImage(folder / "a.PNG");
    ASSERT_TRUE(read);
    EXPECT_TRUE(compare(image, *read).identical);
}

TEST_F(WriteImage, FloatsBecome16BitsInPng) {
    Image image = testing::noisyImage(9, 8, 4, Component::f32);
    EXPECT_TRUE(writeImage(image, folder / "a.png", {{}, {}}).empty());
    const auto read = readImage(folder / "a.png");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->type, Component::u16);
    for (std::size_t at = 0; at < image.data.size(); at += 4) {
        float value = 0;
        std::uint16_t stored = 0;
        std::memcpy(&value, image.data.data() + at, 4);
        std::memcpy(&stored, read->data.data() + at / 2, 2);
        EXPECT_NEAR(stored / 65535., std::min(1.F, std::max(0.F, value)), .5001 / 65535);
    }
}

TEST_F(WriteImage, WithoutTheModuleOtherFormatsAreRejectedAndNothingIsLeft) {
    const auto problems = writeImage(testing::smoothImage(4, 4), folder / "a.exr", {{}, {}});
    ASSERT_EQ(idsOf(problems), "file-E03");
    EXPECT_NE(problems[0].text.find("an EXR picture, but the image module that reads it is not installed"),
              std::string::npos);
    EXPECT_EQ(fileCount(), 0U);
}

TEST_F(WriteImage, AnUnknownSuffixOrAnEmptyPictureIsRejected) {
    EXPECT_EQ(idsOf(writeImage(testing::smoothImage(4, 4), folder / "a.xyz")), "file-E10");
    EXPECT_EQ(idsOf(writeImage(testing::smoothImage(4, 4), folder / "a")), "file-E10");
    EXPECT_EQ(idsOf(writeImage(testing::smoothImage(4, 4), folder / "a.tex")), "file-E10");
    EXPECT_EQ(idsOf(writeImage({}, folder / "a.png")), "file-E10");
    EXPECT_EQ(fileCount(), 0U);
}

TEST_F(WriteImage, EqualPicturesAreEqualFilesWheneverTheyAreWritten) {
    GLIBRA_NEED_MODULE();
    const Image image = testing::noisyImage(33, 21, 3, Component::f32);
    const std::vector<std::string> suffixes{".exr", ".tif", ".tga", ".hdr", ".sgi"};
    for (const std::string& suffix : suffixes)
        EXPECT_TRUE(writeImage(image, folder / ("first" + suffix)).empty()) << suffix;
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // dates have a resolution of one second
    for (const std::string& suffix : suffixes) {
        EXPECT_TRUE(writeImage(image, folder / ("second" + suffix)).empty()) << suffix;
        const auto first = readFile(folder / ("first" + suffix), kFileLabel);
        const auto second = readFile(folder / ("second" + suffix), kFileLabel);
        ASSERT_TRUE(first && second) << suffix;
        EXPECT_EQ(*first, *second) << suffix;
    }
}

/// The bytes follow from the description of the format: no alpha, the bottom row first, little-endian.
TEST_F(WriteImage, APfmHoldsFloatsOutsideOfTheColoursFromBottomToTop) {
    const std::vector<float> pixels{-2.5F, 1000.F, .25F, .5F,
                                    1.F,   2.F,    3.F,  .75F};  // top, bottom; with alpha
    Image image{1, 2, 4, Component::f32, {}};
    image.data.resize(pixels.size() * sizeof(float));
    std::memcpy(image.data.data(), pixels.data(), image.data.size());
    const Diagnostics remarks = writeImage(image, folder / "a.pfm", {{}, {}});
    ASSERT_EQ(remarks.size(), 1U) << "needs no module";
    EXPECT_EQ(remarks[0].id, "file-W14") << "alpha is lost";
    const auto file = readFile(folder / "a.pfm", kFileLabel);
    ASSERT_TRUE(file);
    const std::string header = "PF\n1 2\n-1.0\n";
    ASSERT_EQ(file->size(), header.size() + 6 * sizeof(float));
    EXPECT_EQ(std::memcmp(file->data(), header.data(), header.size()), 0);
    std::array<float, 6> written{};
    std::memcpy(written.data(), file->data() + header.size(), sizeof written);
    EXPECT_EQ(written, (std::array<float, 6>{1.F, 2.F, 3.F, -2.5F, 1000.F, .25F}));
}

TEST_F(WriteImage, AFormatThatCanOnlyBeReadIsRejectedAndNothingIsLeft) {
    GLIBRA_NEED_MODULE();
    EXPECT_EQ(idsOf(writeImage(testing::smoothImage(4, 4), folder / "a.psd", {{}, testing::moduleFolders()})),
              "file-E10");
    EXPECT_EQ(idsOf(writeImage(testing::smoothImage(4, 4), folder / "none" / "a.tif",
                               {{}, testing::moduleFolders()})),
              "file-E10");
    EXPECT_EQ(fileCount(), 0U);
}

}  // namespace
}  // namespace glibra::image
