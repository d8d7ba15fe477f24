// SGI files that are written: their bytes, and what OpenImageIO reads in them.

#include "image/sgi/sgi_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "image/compare/compare.h"
#include "image/convert.h"
#include "image/write.h"
#include "support.h"

namespace glibra::image {
namespace {

/// The bytes follow from the description of the format.
TEST(SgiWriter, TheHeaderHoldsNothingButTheFormAndTheChannelsFollowFromBottomToTop) {
    const Image image{1, 2, 3, Component::u8, testing::bytesOf({1, 2, 3, 4, 5, 6})};
    std::vector<std::byte> expected =
        testing::bytesOf({1, 0xda, 0, 1, 0, 3, 0, 1, 0, 2, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0xff});
    expected.resize(512);
    for (const std::byte each : testing::bytesOf({4, 1, 5, 2, 6, 3})) expected.push_back(each);
    EXPECT_EQ(encodeSgi(image), expected);
}

class WriteSgi : public testing::InFolder {};

TEST_F(WriteSgi, KeepsThePixelsForAnotherDecoder) {
    GLIBRA_NEED_MODULE();
    for (const Component type : {Component::u8, Component::u16, Component::f32})
        for (int components = 1; components <= 4; ++components) {
            const Image image = testing::noisyImage(37, 23, components, type);
            const auto file = encodeSgi(image);
            // OpenImageIO reads this format from files only.
            const auto read =
                readByModule(Format::sgi, file, put("a.sgi", file), {"elsewhere", {}}, testing::withModule());
            ASSERT_TRUE(read) << read.diagnostics[0].text;
            const Image expected =
                withComponents(withType(image, type == Component::f32 ? Component::u16 : type), 4);
            EXPECT_TRUE(compare(expected, *read).identical) << components;
        }
}

TEST_F(WriteSgi, NeedsNoModuleAndRefusesSidesThatTheFormatDoesNotHave) {
    EXPECT_TRUE(writeImage(testing::smoothImage(65535, 1), folder / "a.sgi", {{}, {}}).empty());
    const Diagnostics problems = writeImage(testing::smoothImage(1, 65536), folder / "b.rgb", {{}, {}});
    ASSERT_EQ(testing::idsOf(problems), "file-E10");
    EXPECT_NE(problems[0].text.find("SGI has at most 65535 pixels per side"), std::string::npos);
    EXPECT_EQ(fileCount(), 1U);
}

}  // namespace
}  // namespace glibra::image
