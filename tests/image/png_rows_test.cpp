// The filters that are chosen for the rows of a picture, against the sizes that libdeflate packs them to.

#include "image/png/png_writer.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <algorithm>
#include <memory>

#include "support.h"

namespace glibra::image {
namespace {

constexpr int kRowsSide = 300;

std::uint32_t noiseAt(int x, int y) {
    return testing::hash(static_cast<std::uint32_t>(1000 * y + x)) >> 8U;
}

/// Twelve grey levels in ever new order, a few pixels each: differences only spread the values.
Image steps() {
    return testing::greyImage([](int x, int y) { return noiseAt(x / 3, y / 3) % 12 * 21; }, kRowsSide,
                              kRowsSide);
}

Image columns() {
    return testing::greyImage([](int x, int y) { return noiseAt(x, 0) % 256 + noiseAt(x, y) % 3; }, kRowsSide,
                              kRowsSide);
}

Image lines() {
    return testing::greyImage([](int x, int y) { return noiseAt(0, y) % 256 + noiseAt(x, y) % 3; }, kRowsSide,
                              kRowsSide);
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
    EXPECT_EQ(chooseFiltering(steps(), 0, kRowsSide), PngFiltering::none);
    EXPECT_EQ(chooseFiltering(columns(), 0, kRowsSide), PngFiltering::up);
    EXPECT_NE(chooseFiltering(lines(), 0, kRowsSide), PngFiltering::none);
    EXPECT_NE(chooseFiltering(lines(), 0, kRowsSide), PngFiltering::up);
}

TEST(PngRows, TheChosenFilteringPacksHardlyWorseThanAnyOther) {
    const std::vector<Image> pictures{steps(),
                                      columns(),
                                      lines(),
                                      testing::smoothImage(kRowsSide, kRowsSide),
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
