#include "image/compare/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/parallel.h"
#include "image/bytes.h"
#include "image/compare/alike.h"
#include "image/compare/flip_color.h"
#include "image/compare/flip_filters.h"
#include "image/convert.h"

namespace glibra::image {
namespace {

// The planes of a tile fit into the second-level cache of a core.
constexpr int kTileWidth = 128, kTileHeight = 64;
constexpr std::size_t kTileColumns = kTileWidth;

/// Rows are padded to a multiple of this.
constexpr std::size_t kRowUnit = 8;
constexpr std::size_t roundedUp(std::size_t count) {
    return (count + kRowUnit - 1) / kRowUnit * kRowUnit;
}

/// The linear values of all integers of a type.
template <class Value>
const std::vector<float>& linearTable() {
    static const std::vector<float> table = [] {
        constexpr double kFull = std::numeric_limits<Value>::max();
        std::vector<float> values;
        for (std::size_t i = 0; i <= std::numeric_limits<Value>::max(); ++i) {
            const double v = static_cast<double>(i) / kFull;
            values.push_back(static_cast<float>(v <= .04045 ? v / 12.92 : std::pow((v + .055) / 1.055, 2.4)));
        }
        return values;
    }();
    return table;
}

template <class Value>
float linearValue(const std::byte* row, std::size_t index) {
    if constexpr (std::is_integral_v<Value>) {
        return linearTable<Value>()[valueAt<Value>(row, index)];
    } else {
        const float value = valueAt<float>(row, index);
        return value > 0 ? linearOf(std::min(value, 1.F)) : 0.F;  // 0 for NaN
    }
}

/// Linear RGB of `count` pixels from column x; columns beyond the picture repeat its edge.
template <class Value>
void loadRow(const Image& image, int x, int y, std::size_t count, float* r, float* g, float* b) {
    const std::byte* row = image.row(std::clamp(y, 0, image.height - 1)).data();
    const auto components = static_cast<std::size_t>(image.components);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at =
            static_cast<std::size_t>(std::clamp(x + static_cast<int>(i), 0, image.width - 1)) * components;
        r[i] = linearValue<Value>(row, at);
        g[i] = linearValue<Value>(row, at + 1);
        b[i] = linearValue<Value>(row, at + 2);
    }
}

void loadRow(const Image& image, int x, int y, std::size_t count, float* r, float* g, float* b) {
    withZeroOf(image.type, [&](auto zero) { loadRow<decltype(zero)>(image, x, y, count, r, g, b); });
}

/// The part of one picture in a tile: the rows of the tile and `radius` rows above and below, filtered along
/// the rows.
class FilteredTile {
  public:
    explicit FilteredTile(const FlipFilters& filters)
        : filters_(filters), stride_(roundedUp(kTileColumns + 2 * filters.radius)) {
        for (auto& each : loaded_) each.resize(stride_);
        for (auto& each : along_) each.resize(kTileColumns * (kTileHeight + 2 * filters.radius));
        for (auto& each : done_) each.resize(kTileColumns);
    }

    void load(const Image& image, int left, int top, int height) {
        const int radius = static_cast<int>(filters_.radius);
        for (int y = 0; y < height + 2 * radius; ++y) {
            float *r = loaded_[0].data(), *g = loaded_[1].data(), *b = loaded_[2].data();
            loadRow(image, left - radius, top + y - radius, stride_, r, g, b);
            toOpponent(r, g, b, stride_);
            const std::size_t at = static_cast<std::size_t>(y) * kTileColumns;
            filterBoth(r + radius, 1, kTileColumns, {filters_.achromatic, &along_[luma][at]},
                       {filters_.gauss, &along_[smooth][at]}, {filters_.point, &along_[bend][at]},
                       {filters_.edge, &along_[slope][at]});
            filterSymmetric(g + radius, 1, kTileColumns, {filters_.redGreen, &along_[red][at]});
            filterSymmetric(b + radius, 1, kTileColumns, {filters_.blueYellow1, &along_[blue1][at]},
                            {filters_.blueYellow2, &along_[blue2][at]});
        }
    }

    /// A row of the tile, also filtered down the columns; valid until the next call.
    FilteredRow row(int y) {
        const std::size_t at = (static_cast<std::size_t>(y) + filters_.radius) * kTileColumns;
        const auto down = [&](int plane, const HalfFilter& weights, int result) {
            filterSymmetric(&along_[static_cast<std::size_t>(plane)][at], kTileColumns, kTileColumns,
                            {weights, done_[static_cast<std::size_t>(result)].data()});
            return done_[static_cast<std::size_t>(result)].data();
        };
        FilteredRow result{};
        result.y = down(luma, filters_.achromatic, 0);
        result.cx = down(red, filters_.redGreen, 1);
        result.cz1 = down(blue1, filters_.blueYellow1, 2);
        result.cz2 = down(blue2, filters_.blueYellow2, 3);
        result.dx = down(slope, filters_.gauss, 4);
        result.ddx = down(bend, filters_.gauss, 5);
        filterBoth(&along_[smooth][at], kTileColumns, kTileColumns, {filters_.point, done_[6].data()},
                   {filters_.edge, done_[7].data()});
        result.ddy = done_[6].data();
        result.dy = done_[7].data();
        return result;
    }

  private:
    enum Plane : std::uint8_t { luma, smooth, slope, bend, red, blue1, blue2, planeCount };

    const FlipFilters& filters_;
    std::size_t stride_;
    std::array<std::vector<float>, 3> loaded_;
    std::array<std::vector<float>, planeCount> along_;
    std::array<std::vector<float>, 8> done_;
};

/// True if the pictures have the same bytes in the tile and `radius` pixels around it, so that its errors are
/// 0.
bool sameAroundTile(const Image& a, const Image& b, int left, int top, int radius) {
    const int x = std::max(left - radius, 0), y = std::max(top - radius, 0);
    const int right = std::min(left + kTileWidth + radius, a.width);
    const int bottom = std::min(top + kTileHeight + radius, a.height);
    const std::size_t pixel = static_cast<std::size_t>(a.components) * bytesOf(a.type);
    const std::size_t from = static_cast<std::size_t>(x) * pixel;
    const std::size_t bytes = static_cast<std::size_t>(right - x) * pixel;
    for (int row = y; row < bottom; ++row)
        if (std::memcmp(a.row(row).data() + from, b.row(row).data() + from, bytes) != 0) return false;
    return true;
}

/// The errors of two opaque pictures of three or four components and one type.
std::vector<float> errorsOf(const Image& a, const Image& b, const FlipOptions& options) {
    const FlipFilters filters(options.pixelsPerDegree);
    std::vector<float> errors(static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height));
    const int columns = (a.width + kTileWidth - 1) / kTileWidth;
    const int tiles = columns * ((a.height + kTileHeight - 1) / kTileHeight);
    struct Tiles {
        FilteredTile first, second;
        std::array<float, kTileColumns> rowErrors{};
    };
    base::forEachIndex(
        static_cast<std::size_t>(tiles), options.threads,
        [&] { return Tiles{FilteredTile(filters), FilteredTile(filters)}; },
        [&](std::size_t index, Tiles& buffers) {
            auto& [first, second, rowErrors] = buffers;
            const int tile = static_cast<int>(index);
            const int left = tile % columns * kTileWidth, top = tile / columns * kTileHeight;
            if (sameAroundTile(a, b, left, top, static_cast<int>(filters.radius))) return;
            const int height = std::min(kTileHeight, a.height - top);
            first.load(a, left, top, height);
            second.load(b, left, top, height);
            const auto width = static_cast<std::size_t>(std::min(kTileWidth, a.width - left));
            for (int y = 0; y < height; ++y) {
                flipErrors(first.row(y), second.row(y), kTileColumns, rowErrors.data());
                std::copy_n(rowErrors.data(), width,
                            errors.data() +
                                static_cast<std::size_t>(top + y) * static_cast<std::size_t>(a.width) +
                                static_cast<std::size_t>(left));
            }
        });
    return errors;
}

bool isOpaque(const Image& image) {
    if (image.components == 1 || image.components == 3) return true;
    const Image alpha = withType(image, Component::f32);
    for (std::size_t i = static_cast<std::size_t>(image.components) - 1; i < alpha.data.size() / 4;
         i += static_cast<std::size_t>(image.components))
        if (valueAt<float>(alpha.data.data(), i) != 1) return false;
    return true;
}

/// The RGBA picture over a grey background, blended in sRGB as browsers do.
Image over(const Image& image, float background) {
    Image seen = withType(image, Component::f32);
    for (std::size_t at = 0; at < seen.data.size(); at += 16) {
        std::array<float, 4> pixel{};
        std::memcpy(pixel.data(), seen.data.data() + at, 16);
        const float alpha = std::clamp(pixel[3], 0.F, 1.F);
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = pixel[c] * alpha + background * (1 - alpha);
        pixel[3] = 1;
        std::memcpy(seen.data.data() + at, pixel.data(), 16);
    }
    return seen;
}

/// Sets the error to 1 where one of two float pictures is NaN and the other is not.
void markNan(const Image& a, const Image& b, std::vector<float>& errors) {
    const auto components = static_cast<std::size_t>(a.components);
    for (std::size_t i = 0; i < errors.size() * components; ++i)
        if (std::isnan(valueAt<float>(a.data.data(), i)) != std::isnan(valueAt<float>(b.data.data(), i)))
            errors[i / components] = 1;
}

std::vector<float> errorsOfAlike(const Image& a, const Image& b, const FlipOptions& options) {
    if (a.components < 3) return errorsOfAlike(withComponents(a, 4), withComponents(b, 4), options);
    std::vector<float> errors;
    if (isOpaque(a) && isOpaque(b)) {
        errors = errorsOf(a, b, options);
    } else {
        errors = errorsOf(over(a, 0), over(b, 0), options);
        const std::vector<float> white = errorsOf(over(a, 1), over(b, 1), options);
        for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = std::max(errors[i], white[i]);
    }
    if (a.type == Component::f32) markNan(a, b, errors);
    return errors;
}

}  // namespace

FlipResult flip(const Image& reference, const Image& test, const FlipOptions& options) {
    FlipResult result;
    if (reference.width != test.width || reference.height != test.height || !isConsistent(reference) ||
        !isConsistent(test)) {
        result.mean = result.largest = 1;
        return result;
    }
    result.width = reference.width;
    result.height = reference.height;
    result.errors = withAlike(reference, test,
                              [&](const Image& a, const Image& b) { return errorsOfAlike(a, b, options); });
    double sum = 0;
    for (const float each : result.errors) sum += static_cast<double>(each);
    result.mean = sum / static_cast<double>(result.errors.size());
    const auto worst = std::max_element(result.errors.begin(), result.errors.end());
    result.largest = static_cast<double>(*worst);
    const auto at = static_cast<int>(worst - result.errors.begin());
    result.x = at % result.width;
    result.y = at / result.width;
    return result;
}

}  // namespace glibra::image
