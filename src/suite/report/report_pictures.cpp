#include "suite/report/report_pictures.h"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>

namespace glibra::suite {
namespace {

struct FreeCompressor {
    void operator()(libdeflate_compressor* each) const { libdeflate_free_compressor(each); }
};

std::vector<std::byte> rowsMinusAbove(const image::Image& picture) {
    std::vector<std::byte> bytes = picture.data;
    const std::size_t rowBytes = picture.rowBytes();
    for (std::size_t i = bytes.size(); i-- > rowBytes;)
        bytes[i] = static_cast<std::byte>(std::to_integer<unsigned>(bytes[i]) -
                                          std::to_integer<unsigned>(bytes[i - rowBytes]));
    return bytes;
}

/// The colours without alpha if alpha is 1 everywhere, or nothing.
std::optional<image::Image> withoutAlpha(const image::Image& picture) {
    if (picture.components != 4) return std::nullopt;
    const std::size_t valueBytes = image::bytesOf(picture.type), colorBytes = 3 * valueBytes;
    constexpr std::array<std::byte, 2> kOneOf16{std::byte{255}, std::byte{255}};
    constexpr auto kOneOf32 = std::bit_cast<std::array<std::byte, 4>>(1.F);
    const std::byte* one = picture.type == image::Component::f32 ? kOneOf32.data() : kOneOf16.data();
    image::Image opaque{picture.width, picture.height, 3, picture.type, {}};
    opaque.data.resize(picture.data.size() / 4 * 3);
    const std::byte* from = picture.data.data();
    for (std::size_t to = 0; to < opaque.data.size(); to += colorBytes, from += 4 * valueBytes) {
        if (std::memcmp(from + colorBytes, one, valueBytes) != 0) return std::nullopt;
        std::memcpy(opaque.data.data() + to, from, colorBytes);
    }
    return opaque;
}

}  // namespace

std::string base64(std::span<const std::byte> bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t at) {
            return at < bytes.size() ? std::to_integer<std::uint32_t>(bytes[at]) : 0U;
        };
        const std::uint32_t group = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
        const std::size_t digits = std::min<std::size_t>(bytes.size() - i, 3) + 1;
        for (std::size_t digit = 0; digit < 4; ++digit)
            text += digit < digits ? kDigits[group >> (18 - 6 * digit) & 63U] : '=';
    }
    return text;
}

std::string packedPixels(const image::Image& picture) {
    if (const std::optional<image::Image> opaque = withoutAlpha(picture)) return packedPixels(*opaque);
    constexpr std::array kTypes{"u8", "u16", "f32"};
    constexpr int kLevel = 1;  // fast: a report may have hundreds of failures
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(kLevel));
    const std::vector<std::byte> bytes = rowsMinusAbove(picture);
    std::vector<std::byte> packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
    packed.resize(
        libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
    return fmt::format(R"({{"width":{},"height":{},"components":{},"type":"{}","data":"{}"}})", picture.width,
                       picture.height, picture.components, kTypes.at(static_cast<std::size_t>(picture.type)),
                       base64(packed));
}

namespace {

constexpr int kMostRows = 16;  // characters

using Color = std::array<std::uint8_t, 3>;

/// Rec. 709 weights in 10000ths, applied to the values as they are. That is enough to tell bright from dark.
int brightness(const Color& color) {
    return 2126 * color[0] + 7152 * color[1] + 722 * color[2];
}

/// The cells of a picture; the value of a cell is that of its brightest pixel.
struct Grid {
    int columns, rows;
    std::vector<Color> cells;

    [[nodiscard]] const Color& at(int column, int row) const {
        return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column)];
    }
};

Color brightest(const image::Image& picture, int left, int top, int right, int bottom) {
    Color found{};
    for (int y = top; y < bottom; ++y) {
        const auto* pixel =
            reinterpret_cast<const std::uint8_t*>(picture.row(y).data()) + std::ptrdiff_t{3} * left;
        for (int x = left; x < right; ++x, pixel += 3)
            if (const Color color{pixel[0], pixel[1], pixel[2]}; brightness(color) > brightness(found))
                found = color;
    }
    return found;
}

Grid reduced(const image::Image& picture, int columns, int rows) {
    const auto edge = [](int cell, int cells, int pixels) {
        return static_cast<int>(std::int64_t{cell} * pixels / cells);
    };
    Grid grid{columns, rows, {}};
    for (int row = 0; row < rows; ++row) {
        const int top = edge(row, rows, picture.height);
        const int bottom = std::max(top + 1, edge(row + 1, rows, picture.height));
        for (int column = 0; column < columns; ++column) {
            const int left = edge(column, columns, picture.width);
            const int right = std::max(left + 1, edge(column + 1, columns, picture.width));
            grid.cells.push_back(brightest(picture, left, top, right, bottom));
        }
    }
    return grid;
}

std::string colorRow(const Grid& grid, int row) {
    std::string text;
    for (int column = 0; column < grid.columns; ++column) {
        const Color& above = grid.at(column, row);
        const Color& below = grid.at(column, row + 1);
        text += fmt::format("\033[38;2;{};{};{};48;2;{};{};{}m\u2580", above[0], above[1], above[2], below[0],
                            below[1], below[2]);
    }
    return text + "\033[0m";
}

std::string shadeRow(const Grid& grid, int row) {
    constexpr std::string_view kShades = " .:-=+*#%@";
    constexpr int kBrightest = 255 * 10000;
    std::string text;
    for (int column = 0; column < grid.columns; ++column) {
        const auto shade = static_cast<std::int64_t>(brightness(grid.at(column, row))) *
                           static_cast<std::int64_t>(kShades.size()) / (kBrightest + 1);
        text += kShades[static_cast<std::size_t>(shade)];
    }
    return text;
}

}  // namespace

std::vector<std::string> smallHeatMap(const image::Image& difference, int columns, bool color) {
    if (!image::isConsistent(difference) || columns < 1) return {};
    const image::Image picture = image::withType(image::withComponents(difference, 3), image::Component::u8);
    // A character is about twice as high as it is wide.
    const double rowsPerColumn = 0.5 * picture.height / picture.width;
    columns = std::min(columns, picture.width);
    int rows = static_cast<int>(std::lround(columns * rowsPerColumn));
    if (rows > kMostRows) {
        rows = kMostRows;
        columns = std::clamp(static_cast<int>(std::lround(rows / rowsPerColumn)), 1, columns);
    }
    rows = std::max(rows, 1);
    const Grid grid = reduced(picture, columns, color ? 2 * rows : rows);
    std::vector<std::string> lines;
    lines.reserve(static_cast<std::size_t>(rows));
    for (int row = 0; row < rows; ++row)
        lines.push_back(color ? colorRow(grid, 2 * row) : shadeRow(grid, row));
    return lines;
}

}  // namespace glibra::suite
