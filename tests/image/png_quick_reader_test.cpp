// The fast reader of the most common PNG files: files of libspng's encoder with every filter, and files that
// it must leave to the general reader.

#include "image/png/png_reader.h"

#include <gtest/gtest.h>
#include <spng.h>

#include <memory>

#include "image/compare/compare.h"
#include "image/png/png_writer.h"
#include "support.h"

namespace glibra::image {
namespace {

/// The image as written by libspng, with one filter for all rows.
std::vector<std::byte> bySpng(const Image& image, int filter) {
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(SPNG_CTX_ENCODER),
                                                                 spng_ctx_free);
    spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
    spng_set_option(context.get(), SPNG_FILTER_CHOICE, filter);
    spng_ihdr header{};
    header.width = static_cast<std::uint32_t>(image.width);
    header.height = static_cast<std::uint32_t>(image.height);
    header.bit_depth = image.type == Component::u16 ? 16 : 8;
    header.color_type = image.components == 3 ? SPNG_COLOR_TYPE_TRUECOLOR : SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
    spng_set_ihdr(context.get(), &header);
    EXPECT_EQ(spng_encode_image(context.get(), image.data.data(), image.data.size(), SPNG_FMT_PNG,
                                SPNG_ENCODE_FINALIZE),
              0);
    std::size_t size = 0;
    int error = 0;
    const std::unique_ptr<void, void (*)(void*)> buffer(spng_get_png_buffer(context.get(), &size, &error),
                                                        std::free);
    const auto* bytes = static_cast<const std::byte*>(buffer.get());
    return {bytes, bytes + size};
}

TEST(PngQuickReader, ReadsEveryFilter) {
    constexpr int kFilters[] = {SPNG_FILTER_CHOICE_NONE, SPNG_FILTER_CHOICE_SUB,   SPNG_FILTER_CHOICE_UP,
                                SPNG_FILTER_CHOICE_AVG,  SPNG_FILTER_CHOICE_PAETH, SPNG_FILTER_CHOICE_ALL};
    for (const int components : {3, 4})
        for (const int filter : kFilters)
            for (const int width : {1, 2, 67}) {
                const Image image = testing::noisyImage(width, 45, components, Component::u8);
                const auto read = decodeUsualPng(bySpng(image, filter));
                ASSERT_TRUE(read) << filter;
                EXPECT_EQ(read->components, 4);
                EXPECT_TRUE(compare(image, *read).identical) << components << ' ' << filter << ' ' << width;
            }
}

TEST(PngQuickReader, ReadsPixelsInSeveralChunks) {
    const Image image = testing::noisyImage(300, 200, 3, Component::u8);
    const auto file = bySpng(image, SPNG_FILTER_CHOICE_NONE);
    const auto chunks = pngChunks(file);
    ASSERT_TRUE(chunks);
    ASSERT_GT(chunks->data.size(), 1U) << "libspng writes chunks of 64 KiB";
    const auto read = decodeUsualPng(file);
    ASSERT_TRUE(read);
    EXPECT_TRUE(compare(image, *read).identical);
}

TEST(PngQuickReader, LeavesOtherKindsAlone) {
    EXPECT_FALSE(decodeUsualPng(encodePng(testing::noisyImage(5, 4, 3, Component::u16))));
    EXPECT_FALSE(decodeUsualPng(encodePng(testing::noisyImage(5, 4, 1, Component::u8))));
    EXPECT_FALSE(decodeUsualPng({}));
}

TEST(PngQuickReader, EveryCutAndEveryChangedByteIsDetected) {
    const auto whole = encodePng(testing::noisyImage(5, 4, 4, Component::u8));
    ASSERT_TRUE(decodeUsualPng(whole));
    ASSERT_TRUE(pngChunks(whole));
    for (std::size_t at = 0; at < whole.size(); ++at) {
        EXPECT_FALSE(pngChunks(std::span(whole).first(at))) << at;
        auto changed = whole;
        changed[at] ^= std::byte{0x10};
        EXPECT_FALSE(pngChunks(changed)) << at;
        EXPECT_FALSE(decodeUsualPng(changed)) << at;
    }
    auto longer = whole;
    longer.push_back(std::byte{0});
    EXPECT_FALSE(pngChunks(longer));
}

}  // namespace
}  // namespace glibra::image
