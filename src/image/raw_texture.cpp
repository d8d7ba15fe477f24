#include "image/raw_texture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <string>

#include "image/bytes.h"

namespace glibra::image {
namespace {

std::size_t headerBytes(int dimensions) {
    return 4 * static_cast<std::size_t>(dimensions);
}

/// The sizes at the start of the file for a texture of d dimensions; empty if the file is too short.
std::optional<RawShape> shapeFor(ByteSpan file, int dimensions, Component type) {
    if (file.size() < headerBytes(dimensions)) return std::nullopt;
    RawShape shape{dimensions, {1, 1, 1}, type};
    for (int i = 0; i < dimensions; ++i)
        shape.sizes.at(static_cast<std::size_t>(i)) = little32(file, headerBytes(i));
    return shape;
}

/// The file length of a shape; empty if a size is 0 or the length exceeds 2^62.
std::optional<std::uint64_t> lengthOf(const RawShape& shape) {
    std::uint64_t texels = 1;
    for (const std::uint32_t size : shape.sizes) {
        if (size == 0 || texels > (std::uint64_t{1} << 57) / size) return std::nullopt;
        texels *= size;
    }
    return headerBytes(shape.dimensions) + 4 * bytesOf(shape.type) * texels;
}

/// "2 x 1 x 3".
std::string sizesOf(const RawShape& shape) {
    return fmt::format(
        "{}", fmt::join(std::span(shape.sizes).first(static_cast<std::size_t>(shape.dimensions)), " x "));
}

/// "2 float texels (1D)", "2 x 1 x 3 byte texels (3D)".
std::string describeShape(const RawShape& shape) {
    return fmt::format("{} {} texels ({}D)", sizesOf(shape), shape.type == Component::u8 ? "byte" : "float",
                       shape.dimensions);
}

bool withinSides(const RawShape& shape, const Limits& limits) {
    const int side = shape.dimensions == 3 ? limits.side3D : limits.side;
    return std::all_of(shape.sizes.begin(), shape.sizes.end(), [&](std::uint32_t size) {
        return size >= 1 && size <= static_cast<std::uint32_t>(side);
    });
}

/// file-E05 with the lengths that the sizes at the start of the file require.
Diagnostic fitsNothing(ByteSpan file, int dimensions, const FileLabel& label, const Limits& limits) {
    std::string would;
    for (int d = 1; d <= 3; ++d) {
        if (dimensions != 0 && dimensions != d) continue;
        const auto bytes = shapeFor(file, d, Component::u8);
        if (!bytes || !withinSides(*bytes, limits)) continue;
        std::string sizes = sizesOf(*bytes);
        if (d == 1) sizes += " (1D)";
        const std::uint64_t texels = *lengthOf(*bytes) - headerBytes(d);
        would += fmt::format("{} {} would need {} or {}", would.empty() ? ";" : ",", sizes,
                             headerBytes(d) + texels, headerBytes(d) + 4 * texels);
    }
    if (would.empty()) would = "; it does not start with sizes";
    const std::string kind = dimensions == 0 ? "raw texture" : fmt::format("raw {}D texture", dimensions);
    return diagnose("file-E05",
                    fmt::format("'{}': {} bytes match no {}{}", label.name, file.size(), kind, would),
                    label.place);
}

void toMachineOrder(std::vector<std::byte>& floats) {
    if constexpr (std::endian::native == std::endian::big)
        for (std::size_t at = 0; at + 4 <= floats.size(); at += 4)
            std::reverse(floats.begin() + static_cast<std::ptrdiff_t>(at),
                         floats.begin() + static_cast<std::ptrdiff_t>(at + 4));
}

}  // namespace

std::vector<RawShape> rawShapes(ByteSpan file, int dimensions) {
    std::vector<RawShape> fitting;
    for (int d = 1; d <= 3; ++d)
        for (const Component type : {Component::u8, Component::f32}) {
            if (dimensions != 0 && dimensions != d) continue;
            const auto shape = shapeFor(file, d, type);
            if (shape && lengthOf(*shape) == file.size()) fitting.push_back(*shape);
        }
    return fitting;
}

bool looksRaw(ByteSpan file, int dimensions, const Limits& limits) {
    for (int d = 1; d <= 3; ++d) {
        if (dimensions != 0 && dimensions != d) continue;
        const auto shape = shapeFor(file, d, Component::u8);
        if (shape && withinSides(*shape, limits)) return true;
    }
    return false;
}

Result<TexelBlock> decodeRawTexture(ByteSpan file, int dimensions, const FileLabel& label,
                                    const Limits& limits) {
    const std::vector<RawShape> shapes = rawShapes(file, dimensions);
    if (shapes.empty()) return fitsNothing(file, dimensions, label, limits);
    const RawShape& shape = shapes.front();
    const std::size_t offset = headerBytes(shape.dimensions);
    if (!withinSides(shape, limits) || file.size() - offset > limits.texelBytes)
        return diagnose("file-E09",
                        fmt::format("'{}' has {}, the limits are {} per side and {}", label.name,
                                    describeShape(shape), shape.dimensions == 3 ? limits.side3D : limits.side,
                                    readableBytes(limits.texelBytes)),
                        label.place);
    if (auto over =
            checkSceneBytes(file.size() - offset, limits, fmt::format("'{}'", label.name), label.place))
        return *std::move(over);

    TexelBlock block;
    block.dimensions = shape.dimensions;
    block.width = static_cast<int>(shape.sizes[0]);
    block.height = static_cast<int>(shape.sizes[1]);
    block.depth = static_cast<int>(shape.sizes[2]);
    block.type = shape.type;
    block.data.assign(file.begin() + static_cast<std::ptrdiff_t>(offset), file.end());
    if (shape.type == Component::f32) toMachineOrder(block.data);

    Result<TexelBlock> result(std::move(block));
    if (shapes.size() > 1) {
        std::string all;
        for (const RawShape& each : shapes) all += (all.empty() ? "" : " and ") + describeShape(each);
        result.diagnostics.push_back(diagnose(
            "file-W07", fmt::format("{} bytes match {}; read as {}D", file.size(), all, shape.dimensions),
            label.place));
    }
    return result;
}

}  // namespace glibra::image
