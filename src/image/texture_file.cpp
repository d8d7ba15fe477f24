#include "image/texture_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <new>
#include <numbers>
#include <optional>
#include <string>

#include "base/text.h"
#include "image/bytes.h"
#include "image/format.h"

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
                                    base::readableBytes(limits.texelBytes)),
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

namespace {

namespace fs = std::filesystem;

TexelBlock planeOf(Image image) {
    TexelBlock block;
    block.width = image.width;
    block.height = image.height;
    block.type = image.type;
    block.data = std::move(image.data);
    flipRows(block);
    return block;
}

TexelBlock lineOf(const Image& image) {
    TexelBlock block;
    block.dimensions = 1;
    block.width = image.width;
    block.type = image.type;
    const auto bottom = image.row(image.height - 1);
    block.data.assign(bottom.begin(), bottom.end());
    return block;
}

Result<TexelBlock> fromPicture(Result<Image> read, int dimensions, const FileLabel& label) {
    if (!read) return std::move(read.diagnostics);
    if (dimensions != 1) return {planeOf(*std::move(read.value)), std::move(read.diagnostics)};
    if (read->height > 1)
        read.diagnostics.push_back(
            diagnose("file-W08",
                     fmt::format("'{}' is {} x {}; 1D textures use the bottom row of a picture", label.name,
                                 read->width, read->height),
                     label.place));
    return {lineOf(*read), std::move(read.diagnostics)};
}

Result<TexelBlock> fromRaw(std::span<const std::byte> file, int dimensions, const fs::path& path,
                           const FileLabel& label, const Limits& limits) {
    const Format promised = formatOfSuffix(path);
    // If a file is not meant as a raw texture, the lengths of raw textures do not help its author.
    if (rawShapes(file, dimensions).empty() && promised != Format::rawTexture &&
        !looksRaw(file, dimensions, limits))
        return diagnose("file-E03", fmt::format("'{}' is {}", label.name, describeUnknown(file)),
                        label.place);
    auto result = decodeRawTexture(file, dimensions, label, limits);
    if (result && promised != Format::unknown && promised != Format::rawTexture)
        result.diagnostics.push_back(diagnose(
            "file-W03", fmt::format("'{}' is {}", label.name, describe(Format::rawTexture)), label.place));
    return result;
}

/// Converts the texels to another type; a block is an image of height * depth rows.
TexelBlock withBlockType(TexelBlock block, Component type) {
    if (block.type == type) return block;
    const Image image{block.width, block.height * block.depth, block.components, block.type,
                      std::move(block.data)};
    block.data = withType(image, type).data;
    block.type = type;
    return block;
}

}  // namespace

Result<TexelBlock> readTexture(const base::FileSource& source, int dimensions, const Place& place,
                               const ReadOptions& options) {
    const fs::path& path = source.path;
    const FileLabel label{path.filename().generic_string(), place};
    auto file = readFile(source, label, options.limits.fileBytes);
    if (!file) return std::move(file.diagnostics);
    try {
        const Format format = formatOf(*file);
        if (format == Format::unknown) return fromRaw(*file, dimensions, path, label, options.limits);
        if (dimensions == 3)
            return diagnose("file-E03",
                            fmt::format("'{}' is {}; a 3D texture needs a raw 3D texture file", label.name,
                                        describe(format)),
                            place);
        return fromPicture(decodeImage(*file, path, place, options), dimensions, label);
    } catch (const std::bad_alloc&) {
        return damaged(label, "there is not enough memory to read it");
    }
}

namespace {

/// Pictures that become one texture, in one type.
struct Pictures {
    std::vector<TexelBlock> blocks;
    Component type = Component::u8;
    Diagnostics remarks;
};

/// Reads all of them, so that the messages of all come together. `problemOf` says what is wrong with a
/// picture after the first one, in the words of `command`, or nothing.
template <class ProblemOf>
Pictures readPictures(std::span<const base::FileSource> files, int dimensions, const char* command,
                      const Place& place, const ReadOptions& options, ProblemOf problemOf) {
    Pictures all;
    std::uint64_t bytes = 0;
    ReadOptions rest = options;
    for (const base::FileSource& source : files) {
        auto block = readTexture(source, dimensions, place, rest);
        append(all.remarks, std::move(block.diagnostics));
        if (!block) continue;
        const TexelBlock& first = all.blocks.empty() ? *block : all.blocks.front();
        if (const std::string problem = problemOf(*block, first); !problem.empty()) {
            all.remarks.push_back(diagnose(
                "file-E06",
                fmt::format("{}: '{}' is {} x {}, {}", command, source.path.filename().generic_string(),
                            block->width, block->height, problem),
                place));
            return all;
        }
        all.type = std::max(all.type, block->type);
        bytes += block->data.size();
        rest.limits.sceneBytesLeft -= block->data.size();
        if (bytes > options.limits.texelBytes) {
            all.remarks.push_back(
                diagnose("file-E09",
                         fmt::format("{}: the {} have more than {}, the limit of one texture", command,
                                     std::string_view(command) == "CubeMap" ? "faces" : "pictures",
                                     base::readableBytes(options.limits.texelBytes)),
                         place));
            return all;
        }
        all.blocks.push_back(*std::move(block.value));
    }
    return all;
}

/// The texels of all pictures, one after the other. `flips`: the top row of each comes first.
void join(Pictures& all, bool flips, TexelBlock& to) {
    to.width = all.blocks.front().width;
    to.height = all.blocks.front().height;
    to.type = all.type;
    const std::size_t rowBytes = static_cast<std::size_t>(to.width) * 4 * bytesOf(to.type);
    to.data.reserve(all.blocks.size() * rowBytes * static_cast<std::size_t>(to.height));
    for (TexelBlock& each : all.blocks) {
        each = withBlockType(std::move(each), to.type);
        if (flips) flipRows(each);
        to.data.insert(to.data.end(), each.data.begin(), each.data.end());
        each.data = {};
    }
}

}  // namespace

Result<TexelBlock> readCubeMap(std::span<const base::FileSource> six, const Place& place,
                               const ReadOptions& options) {
    if (six.size() != 6)
        return diagnose("file-E06", fmt::format("CubeMap: expected 6 faces, found {}", six.size()), place);
    Pictures faces = readPictures(six, 2, "CubeMap", place, options, [](const auto& face, const auto& first) {
        return std::string(face.width != face.height || face.width != first.width
                               ? "all faces must be squares of equal size"
                               : "");
    });
    if (hasError(faces.remarks)) return std::move(faces.remarks);
    TexelBlock cube;
    cube.faces = 6;
    join(faces, true, cube);
    return {std::move(cube), std::move(faces.remarks)};
}

Result<TexelBlock> readLayers(std::span<const base::FileSource> files, int dimensions, const Place& place,
                              const ReadOptions& options) {
    Pictures layers =
        readPictures(files, dimensions, "layers", place, options, [](const auto& layer, const auto& first) {
            return layer.width == first.width && layer.height == first.height
                       ? std::string()
                       : fmt::format("the first one is {} x {}; all must have the same size", first.width,
                                     first.height);
        });
    if (hasError(layers.remarks)) return std::move(layers.remarks);
    TexelBlock block;
    block.dimensions = 3;
    block.depth = static_cast<int>(files.size());
    join(layers, false, block);
    return {std::move(block), std::move(layers.remarks)};
}

namespace {

using Color = std::array<double, 4>;

TexelBlock emptyCube(int side, Component type) {
    TexelBlock cube;
    cube.faces = 6;
    cube.width = cube.height = side;
    cube.type = type;
    const auto texels = static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 6;
    cube.data.resize(texels * 4 * bytesOf(type));
    return cube;
}

TexelBlock cubeOfCross(const Image& cross) {
    struct Cell {
        int column, row;
    };
    constexpr std::array<Cell, 6> kCells{{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}};
    const int side = cross.width / 4;
    TexelBlock cube = emptyCube(side, cross.type);
    const std::size_t rowBytes = static_cast<std::size_t>(side) * 4 * bytesOf(cross.type);
    std::byte* to = cube.data.data();
    for (const Cell& cell : kCells)
        for (int y = 0; y < side; ++y, to += rowBytes)
            std::memcpy(
                to, cross.row(cell.row * side + y).data() + static_cast<std::size_t>(cell.column) * rowBytes,
                rowBytes);
    return cube;
}

/// A picture of RGBA floats around the viewer.
class Panorama {
  public:
    explicit Panorama(const Image& floats) : image_(floats) {}

    /// `direction` need not be normalised.
    [[nodiscard]] Color at(const std::array<double, 3>& direction) const {
        const auto [x, y, z] = direction;
        const double length = std::sqrt(x * x + y * y + z * z);
        const double u = .5 + std::atan2(x, -z) / (2 * std::numbers::pi);
        const double v = std::acos(std::clamp(y / length, -1., 1.)) / std::numbers::pi;
        return bilinear(u * image_.width - .5, v * image_.height - .5);
    }

  private:
    [[nodiscard]] Color texel(long x, long y) const {
        const long width = image_.width;
        x = (x % width + width) % width;
        y = std::clamp(y, 0L, static_cast<long>(image_.height) - 1);
        std::array<float, 4> value{};
        std::memcpy(value.data(),
                    image_.row(static_cast<int>(y)).data() + static_cast<std::size_t>(x) * sizeof value,
                    sizeof value);
        return {value[0], value[1], value[2], value[3]};
    }
    [[nodiscard]] Color bilinear(double x, double y) const {
        const double left = std::floor(x), top = std::floor(y);
        Color sum{};
        for (int i = 0; i < 4; ++i) {
            const double weight =
                (i % 2 == 1 ? x - left : 1 - (x - left)) * (i / 2 == 1 ? y - top : 1 - (y - top));
            const Color one = texel(static_cast<long>(left) + i % 2, static_cast<long>(top) + i / 2);
            for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * one[c];
        }
        return sum;
    }
    const Image& image_;
};

TexelBlock cubeOfPanorama(const Image& picture) {
    const Image floats = withType(picture, Component::f32);
    const Panorama panorama(floats);
    const int side = std::max(1, picture.width / 4);
    Image faces{side, side * 6, 4, Component::f32, emptyCube(side, Component::f32).data};
    std::byte* to = faces.data.data();
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x, to += 4 * sizeof(float)) {
                Color mean{};
                for (int i = 0; i < 4; ++i) {
                    const Color one = panorama.at(cubeDirection(face, (x + .25 + .5 * (i % 2)) / side,
                                                                (y + .25 + .5 * (i / 2)) / side));
                    for (std::size_t c = 0; c < 4; ++c) mean[c] += one[c] / 4;
                }
                std::array<float, 4> value{};
                std::transform(mean.begin(), mean.end(), value.begin(),
                               [](double each) { return static_cast<float>(each); });
                std::memcpy(to, value.data(), sizeof value);
            }
    TexelBlock cube = emptyCube(side, picture.type);
    cube.data = withType(faces, picture.type).data;
    return cube;
}

}  // namespace

std::array<double, 3> cubeDirection(int face, double s, double t) {
    const double a = 2 * s - 1, b = 2 * t - 1;
    switch (face) {
        case 0:
            return {1, -b, -a};
        case 1:
            return {-1, -b, a};
        case 2:
            return {a, 1, b};
        case 3:
            return {a, -1, -b};
        case 4:
            return {a, -b, 1};
        default:
            return {-a, -b, -1};
    }
}

Result<TexelBlock> readCubePicture(const base::FileSource& source, const Place& place,
                                   const ReadOptions& options) {
    Result<Image> read = readImage(source, place, options);
    if (!read) return std::move(read.diagnostics);
    const Image picture = withComponents(*read, 4);
    if (picture.width == 2 * picture.height) return {cubeOfPanorama(picture), std::move(read.diagnostics)};
    if (3 * picture.width == 4 * picture.height && picture.width % 4 == 0)
        return {cubeOfCross(picture), std::move(read.diagnostics)};
    read.diagnostics.push_back(diagnose(
        "file-E06",
        fmt::format("CubeMap: '{}' is {} x {}; one picture must be a panorama (2:1) or a cross (4:3)",
                    source.path.filename().generic_string(), picture.width, picture.height),
        place));
    return std::move(read.diagnostics);
}

}  // namespace glibra::image
