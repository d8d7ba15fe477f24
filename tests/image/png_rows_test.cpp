// The filters that are chosen for the rows of a picture, against the sizes that libdeflate packs them to.

#include "image/png/png_rows.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <algorithm>
#include <memory>

#include "support.h"

namespace glibra::image {
namespace {

constexpr int kSide = 300;

/// A grey picture; `value` gives each pixel.
template <class Value>
Image picture(Value value) {
    Image image{kSide, kSide, 1, Component::u8, {}};
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) image.data.push_back(static_cast<std::byte>(value(x, y)));
    return image;
}

std::uint32_t noise(int x, int y) {
    return testing::hash(static_cast<std::uint32_t>(1000 * y + x)) >> 8U;
}

/// Twelve grey levels in ever new order, a few pixels each: differences only spread the values.
Image steps() {
    return picture([](int x, int y) { return noise(x / 3, y / 3) % 12 * 21; });
}

Image columns() {
    return picture([](int x, int y) { return noise(x, 0) % 256 + noise(x, y) % 3; });
}

Image lines() {
    return picture([](int x, int y) { return noise(0, y) % 256 + noise(x, y) % 3; });
}

std::size_t packedBytes(const Image& image, PngFiltering filtering) {
    std::vector<std::uint8_t> rows((1 + image.rowBytes()) * static_cast<std::size_t>(image.height));
    filterRows(image, 0, image.height, filtering, rows.data());
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
        libdeflate_alloc_compressor(4), libdeflate_free_compressor);
    std::vector<std::uint8_t> to(libdeflate_deflate_compress_bound(compressor.get(), rows.size()));
    return libdeflate_deflate_compress(compressor.get(), rows.data(), rows.size(), to.data(), to.size());
}

TEST(PngRows, AreFilteredAsTheirPictureNeedsIt) {
    EXPECT_EQ(chooseFiltering(steps(), 0, kSide), PngFiltering::none);
    EXPECT_EQ(chooseFiltering(columns(), 0, kSide), PngFiltering::up);
    EXPECT_NE(chooseFiltering(lines(), 0, kSide), PngFiltering::none);
    EXPECT_NE(chooseFiltering(lines(), 0, kSide), PngFiltering::up);
}

TEST(PngRows, TheChosenFilteringPacksHardlyWorseThanAnyOther) {
    const std::vector<Image> pictures{steps(),
                                      columns(),
                                      lines(),
                                      testing::smoothImage(kSide, kSide),
                                      testing::noisyImage(90, 90, 4, Component::u8),
                                      testing::noisyImage(90, 90, 3, Component::u16)};
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Image& image = pictures[i];
        const std::size_t chosen = packedBytes(image, chooseFiltering(image, 0, image.height));
        for (const PngFiltering each :
             {PngFiltering::none, PngFiltering::sub, PngFiltering::up, PngFiltering::bestOfEachRow})
            EXPECT_LE(static_cast<double>(chosen), 1.05 * static_cast<double>(packedBytes(image, each)))
                << i << ' ' << static_cast<int>(each);
    }
}

}  // namespace
}  // namespace glibra::image
