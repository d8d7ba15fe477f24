#include "image/texture_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <new>

#include "image/convert.h"
#include "image/file.h"
#include "image/format.h"
#include "image/raw_texture.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;

void flipRows(std::vector<std::byte>& data, std::size_t rowBytes) {
    const std::size_t rows = data.size() / rowBytes;
    for (std::size_t y = 0; y < rows / 2; ++y) {
        const auto top = data.begin() + static_cast<std::ptrdiff_t>(y * rowBytes);
        const auto bottom = data.begin() + static_cast<std::ptrdiff_t>((rows - 1 - y) * rowBytes);
        std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(rowBytes), bottom);
    }
}

TexelBlock planeOf(Image image) {
    TexelBlock block;
    block.width = image.width;
    block.height = image.height;
    block.type = image.type;
    flipRows(image.data, image.rowBytes());
    block.data = std::move(image.data);
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
        read.diagnostics.push_back(diagnose(
            "file-W08",
            fmt::format("Texture1D uses the bottom row of a {} x {} picture", read->width, read->height),
            label.place));
    return {lineOf(*read), std::move(read.diagnostics)};
}

Result<TexelBlock> fromRaw(std::span<const std::byte> file, int dimensions, const fs::path& path,
                           const FileLabel& label, const Limits& limits) {
    const Format promised = formatOfSuffix(path);
    // If a file is not meant as a raw texture, the lengths of raw textures do not help its author.
    if (rawShapes(file, dimensions).empty() && promised != Format::rawTexture &&
        !looksRaw(file, dimensions, limits))
        return diagnose("file-E03", fmt::format("'{}' is {}", label.name, describe(Format::unknown)),
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
    Image image{block.width, block.height * block.depth, block.components, block.type, std::move(block.data)};
    block.data = withType(image, type).data;
    block.type = type;
    return block;
}

}  // namespace

Result<TexelBlock> readTexture(const fs::path& path, int dimensions, const Place& place,
                               const ReadOptions& options) {
    const FileLabel label{path.filename().string(), place};
    auto file = readFile(path, label, options.limits.fileBytes);
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

Result<TexelBlock> readCubeMap(std::span<const fs::path> six, const Place& place,
                               const ReadOptions& options) {
    if (six.size() != 6)
        return diagnose("file-E06", fmt::format("CubeMap: expected 6 faces, found {}", six.size()), place);
    std::vector<TexelBlock> faces;
    Diagnostics remarks;
    Component widest = Component::u8;
    std::uint64_t bytes = 0;
    ReadOptions rest = options;
    for (const fs::path& path : six) {
        auto face = readTexture(path, 2, place, rest);
        append(remarks, std::move(face.diagnostics));
        if (!face) continue;  // all six faces are read, so that the messages of all come together
        const TexelBlock& first = faces.empty() ? *face : faces.front();
        if (face->width != face->height || face->width != first.width) {
            append(remarks,
                   {diagnose("file-E06",
                             fmt::format("CubeMap: '{}' is {} x {}, all faces must be squares of equal size",
                                         path.filename().string(), face->width, face->height),
                             place)});
            return remarks;
        }
        widest = std::max(widest, face->type);
        bytes += face->data.size();
        rest.limits.sceneBytesLeft -= face->data.size();
        if (bytes > options.limits.texelBytes) {
            append(remarks,
                   {diagnose("file-E09",
                             fmt::format("CubeMap: the faces have more than {}, the limit of one texture",
                                         readableBytes(options.limits.texelBytes)),
                             place)});
            return remarks;
        }
        faces.push_back(*std::move(face.value));
    }
    if (hasError(remarks)) return remarks;

    TexelBlock cube;
    cube.faces = 6;
    cube.width = cube.height = faces.front().width;
    cube.type = widest;
    const std::size_t rowBytes = static_cast<std::size_t>(cube.width) * 4 * bytesOf(widest);
    cube.data.reserve(6 * rowBytes * static_cast<std::size_t>(cube.height));
    for (TexelBlock& face : faces) {
        face = withBlockType(std::move(face), widest);
        flipRows(face.data, rowBytes);
        cube.data.insert(cube.data.end(), face.data.begin(), face.data.end());
        face.data = {};
    }
    return {std::move(cube), std::move(remarks)};
}

}  // namespace glibra::image
