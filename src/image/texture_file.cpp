#include "image/texture_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <new>

#include "image/convert.h"
#include "image/file.h"
#include "image/format.h"
#include "image/raw_texture.h"
#include "image/texel_block.h"

namespace glibra::image {
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
    const FileLabel label{path.filename().string(), place};
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
            all.remarks.push_back(
                diagnose("file-E06",
                         fmt::format("{}: '{}' is {} x {}, {}", command, source.path.filename().string(),
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
                                     readableBytes(options.limits.texelBytes)),
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

}  // namespace glibra::image
