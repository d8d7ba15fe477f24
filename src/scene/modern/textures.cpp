// Textures and samplers with names (language, 12.4).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "base/suggest.h"
#include "base/text.h"
#include "glib/number.h"
#include "glib/statement_table.h"
#include "glib/text.h"
#include "scene/classic/classic.h"
#include "scene/modern/modern.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/run/statements.h"
#include "scene/textures.h"

namespace glibra::scene {
namespace {

// ---- The keys of textures and samplers.

/// What stands after a texture or sampler, as far as it is given.
struct TextureOptions {
    std::optional<base::Filter> filter;
    glib::Position filterPosition;
    std::vector<base::Wrap> wraps;
    std::optional<std::array<double, 4>> border;
    std::optional<double> anisotropy;
    std::optional<base::Comparison> compare;
    glib::Position comparePosition;
    std::optional<int> samples, levels;
    const KeyedValues *flip = nullptr, *srgb = nullptr, *generate = nullptr, *history = nullptr;
    const KeyedValues *samplesKey = nullptr, *levelsKey = nullptr;
};

using base::Filter;
using base::Wrap;

constexpr int kMostSamples = 64;
constexpr double kMostAnisotropy = 64;

constexpr std::pair<std::string_view, Filter> kFilters[] = {
    {"nearest", Filter::nearest},
    {"linear", Filter::linear},
    {"mipmap", Filter::linearMipmapLinear},
    {"nearest_mipmap_nearest", Filter::nearestMipmapNearest},
    {"linear_mipmap_nearest", Filter::linearMipmapNearest},
    {"nearest_mipmap_linear", Filter::nearestMipmapLinear},
    {"linear_mipmap_linear", Filter::linearMipmapLinear},
};
constexpr std::pair<std::string_view, Wrap> kWraps[] = {
    {"repeat", Wrap::repeat},
    {"mirror", Wrap::mirroredRepeat},
    {"clamp", Wrap::clampToEdge},
    {"border", Wrap::clampToBorder},
};

template <class T, std::size_t N>
std::optional<T> valueOfWord(const std::pair<std::string_view, T> (&rows)[N], std::string_view word) {
    for (const auto& [name, value] : rows)
        if (name == word) return value;
    return std::nullopt;
}

/// The colour of a border: three or four components, or one for all of a depth texture.
std::optional<std::array<double, 4>> borderColor(Interpreter& in, const Command& command,
                                                 const KeyedValues& key) {
    const auto numbers = floatsOf(in, key.values);
    if (!numbers) return std::nullopt;
    const std::size_t count = numbers->size();
    if (count != 1 && count != 3 && count != 4)
        return refuse(in, "glib-E26", command, key.position,
                      fmt::format("a border has 1, 3 or 4 components, not {}", count));
    std::array<double, 4> color{};
    if (count == 1) color.fill(numbers->front());
    color[3] = 1;
    std::copy(numbers->begin(), numbers->end(), color.begin());
    return color;
}

/// The wrap mode of that word; nothing for other keys.
std::optional<base::Wrap> wrapNamed(std::string_view word) {
    return valueOfWord(kWraps, word);
}

/// `axes`: those that have a wrap mode. Nothing with the reason reported.
std::optional<TextureOptions> readOptions(Interpreter& in, const Command& command, std::size_t axes) {
    TextureOptions options;
    const auto integer = [&](const KeyedValues& key, int most) {
        return integerIn(in, key.values.front(), fmt::format("{}: {}", command.word, key.key), 1, most);
    };
    for (const KeyedValues& key : command.keys) {
        if (const auto filter = valueOfWord(kFilters, key.key)) {
            options.filter = *filter;
            options.filterPosition = key.position;
        } else if (const auto wrap = wrapNamed(key.key)) {
            if (options.wraps.size() == axes)
                return refuse(in, "glib-E18", command, key.position,
                              fmt::format("'{}' is one wrap mode too many; write one, or {}", key.key, axes));
            options.wraps.push_back(*wrap);
            if (key.values.empty()) continue;
            options.border = borderColor(in, command, key);
            if (!options.border) return std::nullopt;
        } else if (key.key == "aniso") {
            options.anisotropy =
                numberIn(in, key.values.front(), command.word + ": aniso", 1, kMostAnisotropy);
            if (!options.anisotropy) return std::nullopt;
        } else if (key.key == "compare") {
            const auto test = wordOf(in, key.values.front(), glib::wordsOfFragment("compare"));
            if (!test) return std::nullopt;
            options.compare = static_cast<base::Comparison>(*test);
            options.comparePosition = key.position;
        } else if (key.key == "samples") {
            options.samples = integer(key, kMostSamples);
            options.samplesKey = &key;
            if (!options.samples) return std::nullopt;
        } else if (key.key == "levels") {
            options.levels = integer(key, 15);
            options.levelsKey = &key;
            if (!options.levels) return std::nullopt;
        } else if (key.key == "flip") {
            options.flip = &key;
        } else if (key.key == "srgb") {
            options.srgb = &key;
        } else if (key.key == "generate") {
            options.generate = &key;
        } else if (key.key == "history") {
            options.history = &key;
        }
    }
    if (options.wraps.size() > 1 && options.wraps.size() < axes)
        return refuse(
            in, "glib-E26", command, command.position,
            fmt::format("{} wrap modes for {} axes; write one, or {}", options.wraps.size(), axes, axes));
    return options;
}

/// The state with what the options say.
base::SamplerState stateOf(const TextureOptions& options, base::SamplerState state) {
    if (options.filter) state.filter = *options.filter;
    if (options.anisotropy) state.anisotropy = *options.anisotropy;
    if (options.border) state.border = *options.border;
    if (options.compare) state.compare = *options.compare;
    for (std::size_t i = 0; i < state.wrap.size() && !options.wraps.empty(); ++i)
        state.wrap[i] = options.wraps[std::min(i, options.wraps.size() - 1)];
    return state;
}

// ---- Textures.

using base::Filter;
using base::Wrap;

constexpr int kLargestSide = 16'384;
constexpr int kLargestSide3 = 2048;  ///< of a 3D texture, and the layers of an array
constexpr std::uint64_t kLargestTexture = std::uint64_t{1} << 30U;  // bytes

/// The dimensions of a texture statement: how many sizes it states.
struct Form {
    CommandId id{};
    TextureTarget target{};
    std::size_t sizes = 2;
    std::size_t components = 2;  ///< of NAME.size
    std::size_t axes = 2;        ///< that have a wrap mode
    /// True if the size at that position counts layers.
    [[nodiscard]] bool countsLayers(std::size_t size) const { return isArray(target) && size == axes; }
};
constexpr Form kForms[] = {
    {CommandId::namedTexture1D, TextureTarget::texture1D, 1, 1, 1},
    {CommandId::namedTexture2D, TextureTarget::texture2D, 2, 2, 2},
    {CommandId::namedTexture3D, TextureTarget::texture3D, 3, 3, 3},
    {CommandId::textureArray1D, TextureTarget::texture1DArray, 2, 2, 1},
    {CommandId::textureArray, TextureTarget::texture2DArray, 3, 3, 2},
    {CommandId::textureRect, TextureTarget::rectangle, 2, 2, 2},
    {CommandId::namedCubeMap, TextureTarget::cube, 1, 2, 2},
};

// ---- Formats and sizes.

/// The format with four components for the name of one with three; empty if there is none.
std::string withFourComponents(std::string_view name) {
    const std::string word = glib::lower(name);
    if (word == "srgb8") return "srgb8_alpha8";
    if (!word.starts_with("rgb") || word.starts_with("rgba")) return {};
    const std::string four = "rgba" + word.substr(3);
    return base::texelFormatNamed(four) ? four : std::string();
}

std::optional<TexelFormat> formatNamed(Interpreter& in, const Command& command, const Value& word) {
    if (const auto format = base::texelFormatNamed(word.text)) return format;
    if (const std::string four = withFourComponents(word.text); !four.empty())
        return refuse(in, "glib-E16", command, word.position,
                      fmt::format("the format '{}' has three components; write '{}'", word.text, four));
    std::vector<std::string_view> names;
    for (const base::TexelFormatRow& row : base::texelFormats()) names.push_back(row.name);
    std::string help = base::suggestion(word.text, names);
    if (help.empty()) help = "; formats are named as in rgba8, r32f, rg16ui, depth24";
    return refuse(in, "glib-E16", command, word.position,
                  fmt::format("unknown format '{}'{}", word.text, help));
}

std::optional<EmptySource> emptySourceOfForm(Interpreter& in, const Command& command, const Form& form) {
    const std::span<const Value> all(command.values);
    const std::span<const Value> sizes = all.subspan(1, all.size() - 2);
    const auto format = formatNamed(in, command, all.back());
    const auto numbers = wholesOf(in, sizes, form.sizes, command.word + ": the size");
    if (!format || !numbers) return std::nullopt;
    EmptySource source{.format = *format};
    const std::array targets{&source.width, &source.height, &source.depth};
    for (std::size_t i = 0; i < form.sizes; ++i) {
        const double size = (*numbers)[i];
        const bool isSmall = form.target == TextureTarget::texture3D || form.countsLayers(i);
        const int most = isSmall ? kLargestSide3 : kLargestSide;
        if (!(size >= 1 && size <= most))
            return refuse(in, size > most ? "glib-E15" : "glib-E05", command, sizes.front().position,
                          fmt::format("the size {} is not between 1 and {}", glib::numberText(size),
                                      base::groupedText(most)));
        *(form.countsLayers(i) ? &source.depth : targets[i]) = static_cast<int>(size);
    }
    if (form.target == TextureTarget::cube) source.height = source.width;
    if (const KeyedValues* layers = command.key("layers")) {
        const auto count =
            integerIn(in, layers->values.front(), command.word + ": layers", 1, kLargestSide3 / 6);
        if (!count) return std::nullopt;
        source.depth = 6 * *count;
    }
    const bool isFlat = form.target == TextureTarget::texture3D || form.target == TextureTarget::texture1D;
    if (isFlat && base::hasDepth(*format))
        return refuse(in, "glib-E32", command, all.back().position,
                      fmt::format("'{}' is for 2D textures, arrays and cube maps", base::name(*format)));
    return source;
}

/// The bytes of all levels, samples and copies of an empty texture.
std::uint64_t bytesOf(const Texture& texture) {
    const auto& source = std::get<EmptySource>(texture.source);
    std::uint64_t texels = 0;
    for (int level = 0; level < levelsOf(texture).value_or(1); ++level) {
        const auto size = *sizeOfLevel(texture, level);
        texels += static_cast<std::uint64_t>(size[0]) * static_cast<std::uint64_t>(size[1]) *
                  static_cast<std::uint64_t>(size[2]);
    }
    return texels * base::bytesPerTexel(source.format) * static_cast<std::uint64_t>(texture.samples);
}

/// Reports `compare` of a texture without depth.
bool mayCompare(Interpreter& in, const Command& command, const TextureOptions& options, bool isDepth) {
    if (!options.compare || isDepth) return true;
    refuse(in, "glib-E32", command, options.comparePosition, "only textures of depth are compared");
    return false;
}

/// Reports options that a rectangle cannot have: levels, and wrap modes that repeat.
bool fitsRectangle(Interpreter& in, const Command& command, const TextureOptions& options,
                   const Texture& texture) {
    if (texture.target != TextureTarget::rectangle) return true;
    const auto deny = [&](glib::Position position, const std::string& text) {
        refuse(in, "glib-E32", command, position, text);
        return false;
    };
    constexpr std::string_view kOneLevel = "'{}': a rectangle has no mipmaps; write Texture2D";
    if (texture.sampler.readsMipmaps())
        return deny(options.filterPosition, "a rectangle has no mipmaps; write 'nearest' or 'linear'");
    for (const KeyedValues* each : {options.generate, options.levelsKey})
        if (each != nullptr) return deny(each->position, fmt::format(kOneLevel, each->key));
    for (const KeyedValues& each : command.keys)
        if (const auto wrap = wrapNamed(each.key); wrap && repeats(*wrap))
            return deny(
                each.position,
                fmt::format("'{}': a rectangle does not repeat; write 'clamp' or 'border'", each.key));
    return true;
}

/// Checks the options of an empty texture against its format, and fills them in.
bool applyToEmpty(Interpreter& in, const Command& command, const TextureOptions& options, Texture& texture) {
    const auto& source = std::get<EmptySource>(texture.source);
    const auto deny = [&](const KeyedValues& key, const std::string& text) {
        refuse(in, "glib-E32", command, key.position, text);
        return false;
    };
    if (options.flip) return deny(*options.flip, "'flip' is for pictures");
    if (options.srgb) return deny(*options.srgb, "'srgb' is for pictures; write the format srgb8_alpha8");
    const bool isInteger = base::isInteger(source.format);
    if (isInteger) {
        const Filter filter = options.filter.value_or(Filter::nearest);
        if (filter != Filter::nearest && filter != Filter::nearestMipmapNearest) {
            refuse(
                in, "glib-E32", command, options.filterPosition,
                fmt::format("'{}' holds integers, which are read with 'nearest'", base::name(source.format)));
            return false;
        }
        texture.sampler.filter = filter;
    }
    if (options.generate && (isInteger || base::hasDepth(source.format)))
        return deny(*options.generate, fmt::format("'{}' has no mipmaps", base::name(source.format)));
    if (!mayCompare(in, command, options, base::hasDepth(source.format))) return false;
    if (base::hasDepth(source.format) && options.wraps.empty()) {
        texture.sampler.wrap.fill(Wrap::clampToBorder);
        texture.sampler.border.fill(base::farthestDepth(texture.sampler.compare));
    } else if (base::hasDepth(source.format) && !options.border) {
        texture.sampler.border.fill(base::farthestDepth(texture.sampler.compare));
    }
    if (!fitsRectangle(in, command, options, texture)) return false;
    texture.hasMipmaps = options.generate != nullptr;
    const bool hasLevels = texture.hasMipmaps || texture.sampler.readsMipmaps();
    texture.levels = options.levels.value_or(hasLevels ? 0 : 1);
    if (options.levels) {
        Texture all = texture;
        all.levels = 0;
        const int most = levelsOf(all).value_or(1);
        if (*options.levels > most)
            return refuse(in, "glib-E05", command, options.levelsKey->position,
                          fmt::format("{} levels, but a texture of this size has {}", *options.levels, most)),
                   false;
    }
    texture.samples = options.samples.value_or(1);
    if (texture.samples == 1) return true;
    if (texture.target != TextureTarget::texture2D && texture.target != TextureTarget::texture2DArray)
        return deny(*options.samplesKey, "only 2D textures and their arrays have several samples");
    if (options.filter || options.generate || options.levels || !options.wraps.empty() || options.anisotropy)
        return deny(*options.samplesKey,
                    "a texture with several samples has no levels and is read without a filter");
    return true;
}

bool applyToPicture(Interpreter& in, const Command& command, const TextureOptions& options,
                    Texture& texture) {
    const auto deny = [&](const KeyedValues* key) {
        if (key == nullptr) return true;
        refuse(in, "glib-E32", command, key->position,
               fmt::format("'{}' is for textures with a size and a format", key->key));
        return false;
    };
    if (!deny(options.samplesKey) || !deny(options.levelsKey) || !deny(options.history)) return false;
    if (!mayCompare(in, command, options, false)) return false;
    if (!fitsRectangle(in, command, options, texture)) return false;
    texture.isFlipped = options.flip != nullptr;
    texture.isSrgb = options.srgb != nullptr;
    texture.hasMipmaps = options.generate != nullptr || texture.sampler.readsMipmaps();
    return true;
}

std::optional<Texture> pictureOf(Interpreter& in, const Command& command, const Form& form) {
    Texture texture;
    const std::span<const Value> files = std::span(command.values).subspan(1);
    const bool isCube = form.target == TextureTarget::cube;
    if (isCube || isArray(form.target) || files.size() > 1) {
        if (files.size() > kLargestSide3)
            return refuse(
                in, "glib-E15", command, files[kLargestSide3].position,
                fmt::format("{} pictures; the limit is {}", files.size(), base::groupedText(kLargestSide3)));
        PictureSource source;
        for (const Value& each : files) source.files.push_back(fileOf(in, each.text, in.place(each)));
        texture.source = std::move(source);
        texture.target = form.target;
        return texture;
    }
    texture = pictureTexture(in, files.front().text, in.place(files.front()), form.sizes);
    texture.target = form.target;
    return texture;
}

/// Gives expressions the size of a texture of files, if the beginning of the first one shows it.
void setPictureSize(Interpreter& in, const std::string& name, const Texture& texture) {
    Environment& names = in.names();
    const auto set = [&](double width, double height, double depth) {
        names.set(name + ".size", std::array{width, height, depth});
    };
    if (const auto* noise = std::get_if<NoiseSource>(&texture.source)) {
        const double side = noise->size;
        return set(side, side, side);
    }
    const std::vector<FileIndex>& files = std::get<PictureSource>(texture.source).files;
    const auto size = sizeOfFile(in.scene.files[files.front()].source(), sideCount(texture.target));
    if (!size)
        return names.forget(
            name + ".size",
            "the size of a file of this format is known only when it is read; PNG, JPEG, BMP and raw files "
            "show theirs before");
    const auto [width, height, depth] = *size;
    const auto count = static_cast<double>(files.size());
    if (texture.target == TextureTarget::texture1DArray) return set(width, count, 1);
    if (texture.target != TextureTarget::cube) return set(width, height, files.size() > 1 ? count : depth);
    const double side = files.size() > 1 ? width : std::max(1., std::floor(width / 4));
    set(side, side, 6);
}

void doNamedTexture(Interpreter& in, const Command& command) {
    const Form& form = *std::ranges::find_if(kForms, [&](const Form& f) { return f.id == command.id; });
    const std::string& name = command.values.front().text;
    if (!declareName(in, command, name, DeclaredName::Kind::texture)) return;
    if (!in.names().declareTexture(name, form.components)) {
        refuse(in, "glib-E36", command, command.values.front().position,
               fmt::format("'{}' has had another meaning in this scene", name));
        return;
    }
    const auto options = readOptions(in, command, form.axes);
    if (!options) return;
    Texture texture;
    const bool isEmpty = isNumeric(command.values[1]);
    if (isEmpty) {
        const auto source = emptySourceOfForm(in, command, form);
        if (!source) return;
        texture.source = *source;
        texture.target = command.key("layers") != nullptr ? TextureTarget::cubeArray : form.target;
    } else {
        auto picture = pictureOf(in, command, form);
        if (!picture) return;
        texture = std::move(*picture);
    }
    texture.name = name;
    texture.place = in.place(command);
    if (form.target == TextureTarget::cube || form.target == TextureTarget::rectangle)
        texture.sampler.wrap.fill(Wrap::clampToEdge);
    texture.sampler = stateOf(*options, texture.sampler);
    texture.hasHistory = options->history != nullptr;
    if (!(isEmpty ? applyToEmpty : applyToPicture)(in, command, *options, texture)) return;
    if (isEmpty) {
        const std::uint64_t bytes = bytesOf(texture);
        if (bytes > kLargestTexture) {
            refuse(in, "glib-E15", command, command.values[1].position,
                   fmt::format("'{}' needs {} bytes; the limit is {}", name, base::groupedText(bytes),
                               base::groupedText(kLargestTexture)));
            return;
        }
        if (!chargeTexels(in, command, bytes * (texture.hasHistory ? 2 : 1))) return;
        const auto& source = std::get<EmptySource>(texture.source);
        const int second = form.countsLayers(1) ? source.depth : source.height;
        const std::array<double, 3> size{static_cast<double>(source.width), static_cast<double>(second),
                                         static_cast<double>(source.depth)};
        in.names().set(name + ".size", size);
    } else {
        setPictureSize(in, name, texture);
    }
    setObject(in, name, in.scene.textures.add(std::move(texture)));
}

void doSampler(Interpreter& in, const Command& command) {
    const std::string& name = command.values.front().text;
    if (!declareName(in, command, name, DeclaredName::Kind::sampler)) return;
    const auto options = readOptions(in, command, 3);
    if (!options) return;
    setObject(
        in, name,
        in.scene.samplers.add({name, stateOf(*options, {}), in.place(command), !options->wraps.empty()}));
}

}  // namespace

std::span<const CommandAction> objectActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::namedTexture1D, doNamedTexture}, {CommandId::namedTexture2D, doNamedTexture},
        {CommandId::namedTexture3D, doNamedTexture}, {CommandId::textureArray1D, doNamedTexture},
        {CommandId::textureArray, doNamedTexture},   {CommandId::textureRect, doNamedTexture},
        {CommandId::namedCubeMap, doNamedTexture},   {CommandId::sampler, doSampler},
    };
    return kActions;
}

}  // namespace glibra::scene
