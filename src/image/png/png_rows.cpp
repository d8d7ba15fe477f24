#include "image/png/png_rows.h"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <vector>

#include "image/png/packed_size.h"
#include "image/png/png_filter.h"

namespace glibra::image {
namespace {

/// Gives rows in PNG's byte order. A row is valid until the next but one is requested.
class Rows {
  public:
    explicit Rows(const Image& image)
        : image_(image), swaps_(image.type != Component::u8 && std::endian::native == std::endian::little) {
        for (auto& each : swapped_) each.resize(swaps_ ? image.rowBytes() : 0);
        zeros_.resize(image.rowBytes());
    }

    /// -1: the row above the first.
    const std::uint8_t* at(int y) {
        if (y < 0) return zeros_.data();
        const auto from = image_.row(y);
        if (!swaps_) return reinterpret_cast<const std::uint8_t*>(from.data());
        std::vector<std::uint8_t>& to = swapped_[static_cast<std::size_t>(y) % 2];
        for (std::size_t i = 0; i < from.size(); i += 2) {
            to[i] = std::to_integer<std::uint8_t>(from[i + 1]);
            to[i + 1] = std::to_integer<std::uint8_t>(from[i]);
        }
        return to.data();
    }

  private:
    const Image& image_;
    bool swaps_;
    std::array<std::vector<std::uint8_t>, 2> swapped_;
    std::vector<std::uint8_t> zeros_;
};

std::size_t pixelBytes(const Image& image) {
    return static_cast<std::size_t>(image.components) * bytesOf(image.type);
}

/// A way to filter, and the estimated size of sampled rows that are filtered in this way and packed.
struct Candidate {
    PngFiltering filtering = PngFiltering::none;
    double bits = 0;
};

/// Consecutive rows, since most repetitions are found in the rows above: a first half for the second to
/// repeat, and the second half, whose size counts.
struct Sample {
    int firstRow = 0, rows = 0, judgedFrom = 0;
};

std::vector<Sample> samplesOf(std::size_t rowSize, int firstRow, int rows) {
    constexpr std::size_t kHalfBytes = std::size_t{18} << 10;  // DEFLATE looks back 32 KiB
    constexpr std::size_t kPeriodBytes = std::size_t{256} << 10;
    const auto half = static_cast<int>(std::clamp<std::size_t>(kHalfBytes / rowSize, 1, 65536));
    const int all = std::min(rows, 2 * half);
    const std::size_t period = std::max(kPeriodBytes, 7 * rowSize * static_cast<std::size_t>(all));
    const auto count = static_cast<int>(
        std::max<std::size_t>(1, (rowSize * static_cast<std::size_t>(rows) + period / 2) / period));
    std::vector<Sample> samples;
    for (int i = 0; i < count; ++i) {
        const int middle = static_cast<int>(rows * (std::int64_t{2} * i + 1) / (std::int64_t{2} * count));
        const int begin = std::clamp(middle - all / 2, 0, rows - all);
        samples.push_back({firstRow + begin, all, all / 2});
    }
    return samples;
}

}  // namespace

void filterRows(const Image& image, int firstRow, int rows, PngFiltering filtering, std::uint8_t* to) {
    PngRowFilter filter(image.rowBytes(), pixelBytes(image));
    Rows source(image);
    const std::uint8_t* above = source.at(firstRow - 1);
    for (int y = firstRow; y < firstRow + rows; ++y, to += 1 + image.rowBytes()) {
        const std::uint8_t* row = source.at(y);
        switch (filtering) {
            case PngFiltering::none:
                filter.write(PngFilter::none, row, above, to);
                break;
            case PngFiltering::sub:
                filter.write(PngFilter::sub, row, above, to);
                break;
            case PngFiltering::up:
                filter.write(PngFilter::up, row, above, to);
                break;
            case PngFiltering::bestOfEachRow:
                filter.writeBest(row, above, to);
                break;
        }
        above = row;
    }
}

PngFiltering chooseFiltering(const Image& image, int firstRow, int rows) {
    constexpr double kMuchLonger = 1.1;
    // Packers find more matches than PackedSize does, and unfiltered rows have the most. The factor made the
    // files of 68 pictures half a percent smaller.
    constexpr double kOfUnfiltered = .95;
    const std::size_t rowSize = 1 + image.rowBytes();
    const std::vector<Sample> samples = samplesOf(rowSize, firstRow, rows);
    const std::size_t most = rowSize * static_cast<std::size_t>(samples.front().rows);
    const auto filtered = std::make_unique_for_overwrite<std::uint8_t[]>(most);
    const auto packed = std::make_unique<PackedSize>();
    std::vector<Candidate> candidates{
        {PngFiltering::bestOfEachRow}, {PngFiltering::none}, {PngFiltering::sub}, {PngFiltering::up}};
    const auto isShorter = [](const Candidate& a, const Candidate& b) { return a.bits < b.bits; };
    for (const Sample& sample : samples) {
        for (Candidate& each : candidates) {
            filterRows(image, sample.firstRow, sample.rows, each.filtering, filtered.get());
            *packed = {};
            packed->readTo(filtered.get(), rowSize * static_cast<std::size_t>(sample.judgedFrom));
            packed->startCounting();
            packed->readTo(filtered.get(), rowSize * static_cast<std::size_t>(sample.rows));
            each.bits += packed->bits() * (each.filtering == PngFiltering::none ? kOfUnfiltered : 1);
        }
        const double least = std::min_element(candidates.begin(), candidates.end(), isShorter)->bits;
        std::erase_if(candidates, [&](const Candidate& each) { return each.bits > kMuchLonger * least; });
    }
    return std::min_element(candidates.begin(), candidates.end(), isShorter)->filtering;
}

}  // namespace glibra::image
