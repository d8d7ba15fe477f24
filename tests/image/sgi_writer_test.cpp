// SGI files that are written: their bytes, and what is read in them.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "image/compare/compare.h"
#include "image/file.h"
#include "image/image.h"
#include "image/write.h"
#include "support.h"

namespace glibra::image {
namespace {

class WriteSgi : public testing::InFolder {};

/// OpenImageIO leaves the name of the picture and the unused bytes as it finds them in memory.
TEST_F(WriteSgi, HeadersHoldNothingButTheForm) {
    GLIBRA_NEED_MODULE();
    const Image image{1, 2, 3, Component::u8, testing::bytesOf({1, 2, 3, 4, 5, 6})};
    ASSERT_TRUE(writeImage(image, folder / "a.sgi", {{}, testing::moduleFolders()}).empty());
    const auto file = readFile(folder / "a.sgi", {"a", {}});
    ASSERT_TRUE(file);
    ASSERT_GT(file->size(), 512U);
    const std::vector<std::byte> begin = testing::bytesOf({1, 0xda});
    EXPECT_TRUE(std::equal(begin.begin(), begin.end(), file->begin()));
    EXPECT_EQ(std::count(file->begin() + 24, file->begin() + 512, std::byte{0}), 512 - 24);
}

TEST_F(WriteSgi, KeepsThePixels) {
    GLIBRA_NEED_MODULE();
    for (const Component type : {Component::u8, Component::u16, Component::f32})
        for (int components = 1; components <= 4; ++components) {
            const Image image = testing::noisyImage(37, 23, components, type);
            ASSERT_TRUE(writeImage(image, folder / "a.sgi", {{}, testing::moduleFolders()}).empty());
            const auto read = readImage(folder / "a.sgi", {}, testing::withModule());
            ASSERT_TRUE(read) << read.diagnostics[0].text;
            const Image expected =
                withComponents(withType(image, type == Component::f32 ? Component::u16 : type), 4);
            EXPECT_TRUE(compare(expected, *read).identical) << components;
        }
}

TEST_F(WriteSgi, RefusesSidesThatTheFormatDoesNotHave) {
    const Diagnostics problems = writeImage(testing::smoothImage(1, 65536), folder / "b.rgb", {{}, {}});
    ASSERT_EQ(testing::idsOf(problems), "file-E10");
    EXPECT_NE(problems[0].text.find("SGI has at most 65535 pixels per side"), std::string::npos);
    EXPECT_EQ(fileCount(), 0U);
}

}  // namespace
}  // namespace glibra::image
