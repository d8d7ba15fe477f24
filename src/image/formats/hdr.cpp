// Radiance's pictures (G. Ward, "Real Pixels", Graphics Gems II). Of the 24 kinds of files that
// tests/image/variant_maker.cpp makes, OpenImageIO 2.4 and stb_image 2.28 read two: others have another first
// corner, which OpenImageIO leaves turned and stb_image refuses, or run lengths of whole pixels, with which
// the one ends and the other gives wrong pixels.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

#include "base/text.h"
#include "image/bytes.h"
#include "image/formats/readers.h"
#include "image/image.h"

namespace glibra::image {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;  // red, green, blue, exponent

/// One axis of the resolution line: "-Y 480" has 480 pixels or rows, from the top one on.
struct HdrAxis {
    bool isX = false, fromMost = false;  ///< y counts upward, so "-Y" begins with the top row
    std::uint64_t size = 0;
};

struct HdrHeader {
    HdrAxis slow, fast;
    std::size_t dataOffset;
};

/// The next line without its end, from `at`, which moves after it; empty if the file has no further one.
std::optional<std::string_view> lineAt(std::string_view file, std::size_t& at) {
    constexpr std::size_t kLongestLine = 4096;
    std::string_view line = file.substr(at, kLongestLine);
    if (line.find('\n') == std::string_view::npos) return std::nullopt;
    line = line.substr(0, line.find('\n'));
    at += line.size() + 1;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::optional<HdrAxis> axisOf(std::string_view& line) {
    const std::string_view name = base::nextWord(line), size = base::nextWord(line);
    if (name.size() != 2 || (name[0] != '-' && name[0] != '+') || (name[1] != 'X' && name[1] != 'Y'))
        return std::nullopt;
    HdrAxis axis{.isX = name[1] == 'X', .fromMost = name[0] == '-'};
    const auto [end, failure] = std::from_chars(size.data(), size.data() + size.size(), axis.size);
    if (failure != std::errc() || end != size.data() + size.size() || axis.size == 0) return std::nullopt;
    return axis;
}

Result<HdrHeader> readHdrHeader(std::string_view file, const FileLabel& label) {
    std::size_t at = 0;
    std::optional<std::string_view> line;
    while ((line = lineAt(file, at)) && !line->empty()) {
        if (!line->starts_with("FORMAT=")) continue;
        std::string_view value = line->substr(line->find('=') + 1);
        const std::string_view format = base::nextWord(value);
        if (format == "32-bit_rle_xyze")
            return damaged(label, "its colours are XYZ, not RGB; 'ra_xyze -r' of Radiance converts them");
        if (format != "32-bit_rle_rgbe")
            return damaged(label, "its FORMAT is not 32-bit_rle_rgbe");  // a text that may be secret
    }
    if (line) line = lineAt(file, at);
    if (!line) return damaged(label, "the file ends within the HDR header");
    const auto slow = axisOf(*line), fast = axisOf(*line);
    if (!slow || !fast || slow->isX == fast->isX || !base::nextWord(*line).empty())
        return damaged(label, "its resolution line is not like '-Y 480 +X 640'");
    return HdrHeader{*slow, *fast, at};
}

/// Reads one line of pixels: run lengths per component, which begin with 2, 2 and the number of pixels, or
/// whole pixels, among which 1 1 1 n repeats the one before n times, and each further one in a row counts 256
/// times as much. False at the end of the file or at damage.
bool readLine(ByteSpan file, std::size_t& at, std::span<Rgbe> line) {
    constexpr std::size_t kLeast = 8, kMost = 0x7fff;
    const bool byComponent = line.size() >= kLeast && line.size() <= kMost && at + 4 <= file.size() &&
                             big16(file, at) == 0x202 && big16(file, at + 2) == line.size();
    if (byComponent) at += 4;
    for (std::size_t component = 0; byComponent && component < 4; ++component)
        for (std::size_t x = 0; x < line.size();) {
            if (at + 2 > file.size()) return false;
            const std::size_t code = octetAt(file, at++);
            const bool isRun = code > 128;
            const std::size_t count = isRun ? code - 128 : code;
            if (count == 0 || count > line.size() - x || at + (isRun ? 1 : count) > file.size()) return false;
            for (std::size_t i = 0; i < count; ++i)
                line[x++][component] = octetAt(file, at + (isRun ? 0 : i));
            at += isRun ? 1 : count;
        }
    unsigned shift = 0;
    for (std::size_t x = 0; !byComponent && x < line.size(); at += 4) {
        if (at + 4 > file.size()) return false;
        std::memcpy(&line[x], file.data() + at, 4);
        const Rgbe pixel = line[x];
        if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
            ++x;
            shift = 0;
            continue;
        }
        const std::size_t count = std::size_t{pixel[3]} << shift;
        if (x == 0 || shift > 24 || count > line.size() - x) return false;
        std::fill_n(line.begin() + static_cast<std::ptrdiff_t>(x), count, line[x - 1]);
        x += count;
        shift += 8;
    }
    return true;
}

}  // namespace

Result<Image> decodeHdr(ByteSpan file, const FileLabel& label, const Limits& limits) {
    const auto read = readHdrHeader(charactersOf(file), label);
    if (!read) return read.diagnostics;
    const HdrAxis &slow = read->slow, &fast = read->fast;
    const std::uint64_t width = slow.isX ? slow.size : fast.size, height = slow.isX ? fast.size : slow.size;
    if (auto refused = checkPacked(width, height, 4 * sizeof(float), file.size(), limits, label))
        return *std::move(refused);

    Image image = blankImage(width, height, Component::f32);
    std::vector<Rgbe> line(static_cast<std::size_t>(fast.size));
    std::size_t at = read->dataOffset;
    for (std::uint64_t i = 0; i < slow.size; ++i) {
        if (!readLine(file, at, line))
            return at + 4 > file.size() ? endsEarly(label, i, slow.size)
                                        : damaged(label, fmt::format("row {} is damaged", i + 1));
        for (std::uint64_t j = 0; j < fast.size; ++j) {
            std::uint64_t x = slow.isX ? i : j, y = slow.isX ? j : i;
            if ((slow.isX ? slow : fast).fromMost) x = width - 1 - x;
            if (!(slow.isX ? fast : slow).fromMost) y = height - 1 - y;
            const auto& [red, green, blue, exponent] = line[j];
            const float unit = exponent == 0 ? 0 : std::ldexp(1.F, exponent - (128 + 8));
            const std::array<float, 4> pixel{static_cast<float>(red) * unit, static_cast<float>(green) * unit,
                                             static_cast<float>(blue) * unit, 1};
            std::memcpy(image.data.data() + (y * width + x) * sizeof pixel, pixel.data(), sizeof pixel);
        }
    }
    return image;
}

}  // namespace glibra::image
