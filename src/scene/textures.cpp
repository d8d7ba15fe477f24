#include "scene/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "base/suggest.h"
#include "base/text.h"
#include "image/file.h"
#include "image/foreign_headers.h"
#include "image/format.h"
#include "noise/noise.h"
#include "system/file.h"

namespace glibra::scene {

// ---- Parts and sizes

bool isArray(TextureTarget target) {
    return target == TextureTarget::texture1DArray || target == TextureTarget::texture2DArray ||
           target == TextureTarget::cubeArray;
}

std::size_t sideCount(TextureTarget target) {
    if (target == TextureTarget::texture1D || target == TextureTarget::texture1DArray) return 1;
    return target == TextureTarget::texture3D ? 3 : 2;
}

std::optional<int> levelsOf(const Texture& texture) {
    const auto* empty = std::get_if<EmptySource>(&texture.source);
    if (empty == nullptr) {
        if (texture.hasMipmaps) return std::nullopt;
        return 1;
    }
    // A texture with mipmaps has all of them, unless the scene says how many.
    const int wanted = texture.hasMipmaps && texture.levels == 1 ? 0 : texture.levels;
    if (wanted > 0) return wanted;
    const int depth = texture.target == TextureTarget::texture3D ? empty->depth : 1;
    const int height = sideCount(texture.target) > 1 ? empty->height : 1;
    return static_cast<int>(
        std::bit_width(static_cast<unsigned>(std::max({1, empty->width, height, depth}))));
}

std::optional<std::array<int, 3>> sizeOfLevel(const Texture& texture, int level) {
    const auto* empty = std::get_if<EmptySource>(&texture.source);
    if (empty == nullptr) return std::nullopt;
    const auto smaller = [&](int side) { return std::max(1, side >> std::clamp(level, 0, 30)); };
    std::array<int, 3> size{smaller(empty->width), smaller(empty->height), 1};
    if (sideCount(texture.target) == 1) size[1] = 1;
    if (texture.target == TextureTarget::cube) size[2] = 6;
    if (isArray(texture.target)) size[2] = std::max(1, empty->depth);
    if (texture.target == TextureTarget::texture3D) size[2] = smaller(empty->depth);
    return size;
}

std::optional<int> layersOf(const Texture& texture, int level) {
    if (const auto size = sizeOfLevel(texture, level)) return (*size)[2];
    if (texture.target == TextureTarget::cube) return 6;
    const auto* picture = std::get_if<PictureSource>(&texture.source);
    if (picture == nullptr || picture->files.size() < 2) return std::nullopt;
    return static_cast<int>(picture->files.size());
}

std::optional<std::array<int, 2>> targetSize(const Scene& scene, const Pass& pass) {
    if (pass.isWindow) return std::nullopt;
    TextureIndex texture;
    int level = 0;
    if (!pass.targets.empty()) {
        texture = pass.targets.front();
        if (!pass.parts.empty()) level = pass.parts.front().level.value_or(0);
    } else if (pass.depth) {
        texture = pass.depth->texture;
        level = pass.depth->level.value_or(0);
    }
    if (!texture) return std::nullopt;
    const auto size = sizeOfLevel(scene.textures[texture], level);
    if (!size) return std::nullopt;
    return std::array{(*size)[0], (*size)[1]};
}

std::optional<int> faceNamed(std::string_view word) {
    static constexpr std::string_view kFaces[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
    const auto* const found = std::ranges::find(kFaces, word);
    if (found == std::end(kFaces)) return std::nullopt;
    return static_cast<int>(found - std::begin(kFaces));
}

std::string_view wordOf(TextureTarget target) {
    switch (target) {
        case TextureTarget::texture1D:
            return "1D";
        case TextureTarget::texture2D:
            return "2D";
        case TextureTarget::texture3D:
            return "3D";
        case TextureTarget::cube:
            return "cube";
        case TextureTarget::cubeArray:
            return "cubeArray";
        case TextureTarget::rectangle:
            return "rectangle";
        case TextureTarget::texture1DArray:
            return "1DArray";
        case TextureTarget::texture2DArray:
            break;
    }
    return "2DArray";
}

// ---- Names

namespace {

/// Takes ".word" or ".word(number)" from the front; false if there is none.
bool takePart(std::string_view& text, std::string_view& word, std::optional<int>& number) {
    if (!text.starts_with('.')) return false;
    const std::size_t end = std::min(text.find_first_of(".(", 1), text.size());
    word = text.substr(1, end - 1);
    number.reset();
    text.remove_prefix(end);
    if (!text.starts_with('(')) return true;
    const std::size_t close = text.find(')');
    if (close == std::string_view::npos) return false;
    text.remove_prefix(1);
    number = word == "face" ? faceNamed(text.substr(0, close - 1)) : std::nullopt;
    if (number) {
        text.remove_prefix(close);
        return true;
    }
    int value = 0;
    const auto [last, problem] = std::from_chars(text.data(), text.data() + close - 1, value);
    if (problem != std::errc() || last != text.data() + close - 1 || value < 0) return false;
    number = value;
    text.remove_prefix(close);
    return true;
}

Diagnostic badName(std::string_view text, const std::string& why) {
    return withoutId(Severity::error, fmt::format("'{}': {}", text, why));
}

std::vector<std::string_view> namesOfTextures(const Scene& scene) {
    std::vector<std::string_view> names;
    for (const TextureIndex each : scene.textures.indices())
        if (!scene.textures[each].name.empty()) names.push_back(scene.textures[each].name);
    return names;
}

}  // namespace

Result<TextureView> textureNamed(const Scene& scene, std::string_view text) {
    const auto bad = [&](const std::string& why) { return badName(text, why); };
    std::string_view rest = text;
    const std::string_view name = rest.substr(0, rest.find('.'));
    rest.remove_prefix(name.size());
    TextureView view;
    for (const TextureIndex each : scene.textures.indices())
        if (!name.empty() && scene.textures[each].name == name) view.texture = each;
    if (!view.texture)
        return bad(fmt::format("the scene has no texture of that name{}",
                               base::suggestion(name, namesOfTextures(scene))));
    const Texture& texture = scene.textures[view.texture];
    std::optional<int> layer, face;
    while (!rest.empty()) {
        std::string_view word;
        std::optional<int> number;
        const bool isPart = takePart(rest, word, number);
        if (isPart && word == "level" && number)
            view.level = number;
        else if (isPart && word == "layer" && number)
            layer = number;
        else if (isPart && word == "face" && number)
            face = number;
        else if (isPart && word == "prev" && !number)
            view.isPrevious = true;
        else
            return bad("expected .level(n), .layer(n), .face(n) or .prev after the name");
    }
    view.layer = face ? face : layer;
    if (texture.target == TextureTarget::cubeArray && view.layer) {
        const int cubes = layersOf(texture, 0).value_or(0) / 6;
        if (!layer || !face || *layer >= cubes || *face > 5)
            return bad(fmt::format("'{0}' has {1}; write {0}.layer(0).face(0), with a face from 0 to 5", name,
                                   base::counted(cubes, "layer")));
        view.layer = 6 * *layer + *face;
    }
    const auto levels = levelsOf(texture);
    if (view.level && levels && *view.level >= *levels)
        return bad(fmt::format("'{}' has {}", name, base::counted(*levels, "level")));
    if (view.isPrevious && !texture.hasHistory)
        return bad(fmt::format("'{}' is declared without history", name));
    return view;
}

Result<ObjectView> objectNamed(const Scene& scene, std::string_view text) {
    const std::string_view name = text.substr(0, text.find('.'));
    const std::string_view part = text.substr(name.size());
    std::vector<std::string_view> names = namesOfTextures(scene);
    const bool isTexture = std::ranges::find(names, name) != names.end();
    for (const BufferIndex each : scene.buffers.indices()) {
        const Buffer& buffer = scene.buffers[each];
        if (buffer.name == text) return ObjectView(BufferView{each});  // of a mesh: "teapot.position"
        names.push_back(buffer.name);
        if (isTexture || name.empty() || buffer.name != name) continue;
        if (part.empty()) return ObjectView(BufferView{each});
        if (part != ".prev") return badName(text, "after the name of a buffer only .prev may stand");
        if (!buffer.hasHistory) return badName(text, fmt::format("'{}' is declared without history", name));
        return ObjectView(BufferView{each, true});
    }
    if (!isTexture)
        return badName(text, fmt::format("the scene has no texture or buffer of that name{}",
                                         base::suggestion(name, names)));
    Result<TextureView> view = textureNamed(scene, text);
    if (!view) return std::move(view.diagnostics);
    return ObjectView(*view);
}

// ---- Files

namespace {

constexpr std::size_t kLookedAt = 32;

/// A file's first bytes and its length.
struct Beginning {
    std::array<std::byte, kLookedAt> bytes{};
    std::size_t count = 0;
    std::uint64_t length = 0;

    [[nodiscard]] std::uint64_t integer(std::size_t index) const {
        std::uint64_t value = 0;
        for (std::size_t i = 4; i-- > 0;)
            value = value << 8U | std::to_integer<std::uint64_t>(bytes[4 * index + i]);
        return value;
    }
};

std::optional<Beginning> beginningOf(const base::FileSource& source) {
    Beginning beginning;
    if (source.content) {
        const auto bytes = std::as_bytes(std::span(*source.content));
        beginning.length = bytes.size();
        beginning.count = std::min(bytes.size(), kLookedAt);
        std::ranges::copy(bytes.first(beginning.count), beginning.bytes.begin());
    } else if (const system::File file = system::openToRead(source.path, system::Links::followed)) {
        system::FileFacts facts;
        if (factsOf(file, facts) != 0 || facts.kind != system::FileKind::regular) return std::nullopt;
        beginning.length = facts.size;
        if (readFull(file, beginning.bytes, beginning.count) != 0) return std::nullopt;
    }
    if (beginning.count == 0) return std::nullopt;
    return beginning;
}

/// True if the file's length is 4 d + 4 c * (product of the d sizes), with c bytes per component and all
/// sizes at least 1.
bool fitsRaw(const Beginning& beginning, std::size_t dimensions, std::uint64_t componentBytes) {
    const std::uint64_t header = 4 * dimensions;
    if (beginning.count < header || beginning.length <= header) return false;
    std::uint64_t texels = 1;
    const std::uint64_t most =
        beginning.length;  // a file has no more texels than bytes; the limit also prevents overflow
    for (std::size_t i = 0; i < dimensions; ++i) {
        const std::uint64_t size = beginning.integer(i);
        if (size == 0 || size > most / texels) return false;
        texels *= size;
    }
    return beginning.length - header == 4 * componentBytes * texels;
}

std::optional<std::array<double, 3>> sizeOfJpeg(const base::FileSource& source) {
    const auto bytes = image::readFile(source, {source.path.generic_string(), {}});
    const image::JpegFacts facts = bytes ? image::jpegFacts(*bytes) : image::JpegFacts();
    if (facts.width == 0 || facts.height == 0) return std::nullopt;
    return std::array<double, 3>{static_cast<double>(facts.width), static_cast<double>(facts.height), 1};
}

}  // namespace

std::optional<std::array<double, 3>> sizeOfFile(const base::FileSource& source, std::size_t dimensions) {
    const auto beginning = beginningOf(source);
    if (!beginning) return std::nullopt;
    const auto byte = [&](std::size_t at) { return std::to_integer<std::uint32_t>(beginning->bytes.at(at)); };
    const auto whole = [](std::uint32_t value) {
        return std::abs(static_cast<double>(static_cast<std::int32_t>(value)));
    };
    constexpr std::size_t kNeeded = 26;  // the head of a PNG or BMP up to its size
    std::array<double, 3> size{1, 1, 1};
    switch (image::formatOf(std::span(beginning->bytes).first(beginning->count))) {
        case image::Format::jpeg:
            return sizeOfJpeg(source);
        case image::Format::png:
            if (beginning->count < kNeeded) return std::nullopt;
            for (std::size_t i = 0; i < 2; ++i) {
                const std::size_t at = 16 + 4 * i;
                size.at(i) = whole(byte(at) << 24U | byte(at + 1) << 16U | byte(at + 2) << 8U | byte(at + 3));
            }
            break;
        case image::Format::bmp:
            if (beginning->count < kNeeded) return std::nullopt;
            for (std::size_t i = 0; i < 2; ++i) {
                const bool isCore = byte(14) == 12;  // BITMAPCOREHEADER
                const std::size_t at = 18 + (isCore ? 2 : 4) * i;
                const std::uint32_t low = byte(at) | byte(at + 1) << 8U;
                // The height of rows from the top is negative.
                size.at(i) = whole(isCore ? low : low | byte(at + 2) << 16U | byte(at + 3) << 24U);
            }
            break;
        case image::Format::unknown: {
            if (!fitsRaw(*beginning, dimensions, 1) && !fitsRaw(*beginning, dimensions, 4))
                return std::nullopt;
            for (std::size_t i = 0; i < dimensions; ++i)
                size.at(i) = static_cast<double>(beginning->integer(i));
            break;
        }
        default:
            return std::nullopt;
    }
    if (dimensions == 1) size[1] = 1;
    return size;
}

TextureTarget targetOfFile(const base::FileSource& source) {
    const auto beginning = beginningOf(source);
    if (!beginning) return TextureTarget::texture2D;
    const std::span<const std::byte> bytes(beginning->bytes.data(), beginning->count);
    if (image::formatOf(bytes) != image::Format::unknown) return TextureTarget::texture2D;
    constexpr std::array kTargets{TextureTarget::texture1D, TextureTarget::texture2D,
                                  TextureTarget::texture3D};
    for (std::size_t i = 0; i < kTargets.size(); ++i)
        if (fitsRaw(*beginning, i + 1, 1) || fitsRaw(*beginning, i + 1, 4)) return kTargets[i];
    return TextureTarget::texture2D;
}

bool holdsNoise(const base::FileSource& source, int dimensions, int size) {
    const auto beginning = beginningOf(source);
    if (!beginning || !fitsRaw(*beginning, static_cast<std::size_t>(dimensions), 1)) return false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions); ++i)
        if (beginning->integer(i) != static_cast<std::uint64_t>(size)) return false;
    return true;
}

std::optional<NoiseName> noiseNameOf(std::string_view fileName) {
    constexpr std::string_view kMiddle = "d.";
    constexpr std::string_view kSuffix = ".tex";
    const std::string name = base::lower(fileName.substr(fileName.find_last_of("/\\") + 1));
    NoiseName noise;
    if (name.starts_with("noise2"))
        noise.dimensions = 2;
    else if (!name.starts_with("noise3"))
        return std::nullopt;
    const std::size_t start = 6 + kMiddle.size();
    if (name.size() < start + 3 + kSuffix.size() || name.substr(6, kMiddle.size()) != kMiddle ||
        !name.ends_with(kSuffix))
        return std::nullopt;
    const char* const end = name.data() + name.size() - kSuffix.size();
    const auto [stop, failure] = std::from_chars(name.data() + start, end, noise.size);
    if (failure != std::errc() || stop != end) return std::nullopt;
    const int largest = noise.dimensions == 2 ? noise::kLargestSize2 : noise::kLargestSize3;
    return noise.size >= 1 && noise.size <= largest ? std::optional(noise) : std::nullopt;
}

std::string noiseFileName(int dimensions, int size) {
    return fmt::format("noise{}d.{:03}.tex", dimensions, size);
}

FileReference noiseFileBeside(const SearchFolders& folders, int dimensions, int size, const Place& place) {
    FileReference file{noiseFileName(dimensions, size), {}, {}, place};
    const base::FileSource source = folders.sourceAt(folders.beside.front() / file.name);
    if (source.path.empty()) return file;
    if (holdsNoise(source, dimensions, size)) {
        if (!source.content && !folders.mayRead(source.path)) return file;
        file.path = source.path;
        file.content = source.content;
        file.remarks.push_back(
            diagnose("file-N01", fmt::format("noise is read from '{}' beside the scene", file.name), place));
    } else {
        const std::string texels =
            dimensions == 2 ? fmt::format("{0} x {0}", size) : fmt::format("{0} x {0} x {0}", size);
        file.remarks.push_back(diagnose(
            "file-W10", fmt::format("'{}' does not hold {} byte texels; it is ignored", file.name, texels),
            place));
    }
    return file;
}

}  // namespace glibra::scene
