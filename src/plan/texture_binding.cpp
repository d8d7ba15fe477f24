#include "plan/texture_binding.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <utility>

#include "base/text.h"
#include "plan/uniform_names.h"
#include "scene/textures.h"

namespace glibra::plan {
namespace {

scene::TextureIndex textureInSlot(const scene::Scene& scene, scene::SlotTableIndex table, int unit,
                                  scene::TextureTarget target) {
    if (!table) return {};
    for (const scene::Slot& slot : scene.slotTables[table])
        if (slot.unit == unit && slot.target == target) return slot.texture;
    return {};
}

bool isNoiseTexture(const scene::Scene& scene, scene::TextureIndex texture) {
    return texture && std::holds_alternative<scene::NoiseSource>(scene.textures[texture].source);
}

bool fetchesTexels(const ProgramInterface& interface) {
    const auto& stages = interface.facts.stages;
    return std::ranges::any_of(stages,
                               [](const glsl::TranslatedStage& each) { return each.facts.fetchesTexels; });
}

}  // namespace

Result<std::vector<UnitUse>> assignUnits(const ProgramInterface& interface,
                                         std::span<const SamplerBinding> samplers, int maxTextureUnits,
                                         int maxImageUnits) {
    std::vector<UnitUse> uses;
    uses.reserve(samplers.size());
    std::map<std::pair<int, std::string>, int> textureUnits;
    std::map<std::pair<int, std::string>, int> imageUnits;
    int bound = 0;  // samplers of named textures, which share no unit
    for (const SamplerBinding& sampler : samplers) {
        const ValueType& type = at(interface.uniforms, sampler.uniform).type;
        auto& units = type.base == BaseType::image ? imageUnits : textureUnits;
        const int next = static_cast<int>(units.size());
        const int unit = sampler.bound ? -++bound : sampler.unit;
        uses.push_back({sampler, units.try_emplace({unit, type.word}, next).first->second});
    }
    const auto tooMany = [](const char* kind, std::size_t wanted, int available) {
        return diagnose("draw-E13",
                        fmt::format("the program needs {} {} units at once; the graphics device has {}",
                                    wanted, kind, available));
    };
    if (textureUnits.size() > static_cast<std::size_t>(std::max(maxTextureUnits, 0)))
        return tooMany("texture", textureUnits.size(), maxTextureUnits);
    if (imageUnits.size() > static_cast<std::size_t>(std::max(maxImageUnits, 0)))
        return tooMany("image", imageUnits.size(), maxImageUnits);
    return uses;
}

std::vector<TextureUse> textureUses(const scene::Scene& scene, scene::SlotTableIndex slots,
                                    const scene::Sampling& sampling, const ProgramInterface& interface,
                                    std::span<const UnitUse> units) {
    std::vector<TextureUse> uses;
    uses.reserve(units.size());
    for (const UnitUse& unit : units) {
        const ValueType& type = at(interface.uniforms, unit.binding.uniform).type;
        TextureUse use;
        use.uniform = unit.binding.uniform;
        use.element = unit.binding.element;
        use.driverUnit = unit.driverUnit;
        use.isImage = type.base == BaseType::image;
        if (const std::optional<BoundTexture>& bound = unit.binding.bound) {
            if (use.isImage) use.imageFormat = imageFormatOf(interface, at(interface.uniforms, use.uniform));
            if (bound->buffer.buffer) {
                useBuffer(scene, bound->buffer, use);
            } else {
                useNamed(scene, bound->view, type, use);
                use.readsMipmaps = use.view.level ? *use.view.level > 0
                                                  : use.sampler.readsMipmaps() || fetchesTexels(interface);
            }
            uses.push_back(use);
            continue;
        }
        if (type.target) {
            use.target = *type.target;
            use.view.texture = textureInSlot(scene, slots, unit.binding.unit, use.target);
        }
        if (use.target == scene::TextureTarget::cube ||
            (sampling.clamp && !isNoiseTexture(scene, use.view.texture)))
            use.sampler.wrap.fill(base::Wrap::clampToEdge);
        uses.push_back(use);
    }
    return uses;
}

std::string slotText(int unit, scene::TextureTarget target) {
    return fmt::format("{} / {}", unit, scene::wordOf(target));
}

namespace {

using scene::TextureTarget;

/// A kind of texture in GLSL, after "sampler" or "image", and in messages.
struct Dimension {
    std::string_view word;
    TextureTarget target;
    std::string_view name;
};
constexpr Dimension kDimensions[] = {{"1D", TextureTarget::texture1D, "a 1D texture"},
                                     {"2D", TextureTarget::texture2D, "a 2D texture"},
                                     {"3D", TextureTarget::texture3D, "a 3D texture"},
                                     {"Cube", TextureTarget::cube, "a cube map"},
                                     {"1DArray", TextureTarget::texture1DArray, "a 1D array"},
                                     {"2DArray", TextureTarget::texture2DArray, "a 2D array"},
                                     {"CubeArray", TextureTarget::cubeArray, "an array of cube maps"},
                                     {"2DRect", TextureTarget::rectangle, "a rectangle"}};

const Dimension& dimensionOf(TextureTarget target) {
    return *std::ranges::find(kDimensions, target, &Dimension::target);
}

std::optional<base::TexelFormat> formatOf(const scene::Texture& texture) {
    if (const auto* empty = std::get_if<scene::EmptySource>(&texture.source)) return empty->format;
    return std::nullopt;
}

BaseType texelsOfFormat(const std::optional<base::TexelFormat>& format) {
    if (!format || !isInteger(*format)) return BaseType::floating;
    return base::rowOf(*format).kind == base::TexelClass::integer ? BaseType::integer
                                                                  : BaseType::unsignedInteger;
}

/// What a shader sees of the view: a layer or face is 2D, that of a 1D array 1D. Images also take a layer of
/// a 3D texture.
TextureTarget targetOf(const scene::Texture& texture, const scene::TextureView& view) {
    if (!view.layer || texture.target == TextureTarget::rectangle) return texture.target;
    return scene::sideCount(texture.target) == 1 ? TextureTarget::texture1D : TextureTarget::texture2D;
}

/// "sampler2D", "uimage3D": the type that reads this view. `asFormat`: that of an image in place of the
/// texture's own.
std::string fittingWord(const scene::Texture& texture, const scene::TextureView& view, bool isImage,
                        const SamplerType& asked, const std::optional<base::TexelFormat>& asFormat = {}) {
    const BaseType texels = asFormat ? texelsOfFormat(asFormat) : texelsOf(texture);
    std::string word = fmt::format("{}{}", prefixOf(texels), isImage ? "image" : "sampler");
    const TextureTarget target = targetOf(texture, view);
    const auto format = formatOf(texture);
    const bool isDepth = format && hasDepth(*format);
    const bool mustReadSamples = texture.samples > 1 && (isDepth || texels != BaseType::floating);
    if (mustReadSamples || (asked.isMultisampled && texture.samples > 1))
        return word + (target == TextureTarget::texture2DArray ? "2DMSArray" : "2DMS");
    word += dimensionOf(target).word;
    if (asked.isShadow && isDepth) word += "Shadow";
    return word;
}

std::string describeView(const scene::Texture& texture, const scene::TextureView& view) {
    std::string text(dimensionOf(texture.target).name);
    if (view.layer)
        text = fmt::format("a {} of {}", texture.target == TextureTarget::cubeArray ? "face" : "layer", text);
    if (const auto format = formatOf(texture)) text += fmt::format(" of {}", name(*format));
    if (texture.samples > 1) text += fmt::format(" with {} samples", texture.samples);
    return text;
}

std::string placeOf(const ProgramInterface& interface, const ActiveUniform& uniform) {
    const auto declared = interface.facts.uniforms.find(std::string(rootName(uniform.name)));
    if (declared == interface.facts.uniforms.end() || declared->second.place.file.empty()) return {};
    const Place& place = declared->second.place;
    return fmt::format(" ({}:{})", std::filesystem::path(place.file).filename().generic_string(), place.line);
}

/// Why an image of the format `declared` cannot see texels of `format`; empty if it can. GL reinterprets
/// texels of equal size.
std::string sizeProblem(const std::optional<base::TexelFormat>& declared,
                        const std::optional<base::TexelFormat>& format) {
    if (!declared || !format || base::bytesPerTexel(*declared) == base::bytesPerTexel(*format)) return {};
    return fmt::format("; the image has the format {}, whose texels have {} bytes, not {}", name(*declared),
                       base::bytesPerTexel(*declared), base::bytesPerTexel(*format));
}

/// bindingProblem() of a buffer.
std::optional<Diagnostic> bufferProblem(const scene::Scene& scene, const ProgramInterface& interface,
                                        const ActiveUniform& uniform, const BoundTexture& bound) {
    const scene::Buffer& buffer = scene.buffers[bound.buffer.buffer];
    const auto say = [&](const std::string& why) {
        return diagnose(
            "draw-E09",
            fmt::format("{} '{}'{} cannot read buffer '{}' (line {}){}", uniform.type.word, uniform.name,
                        placeOf(interface, uniform), buffer.name, buffer.place.line, why),
            bound.place);
    };
    const auto format = texelsOfType(buffer.type);
    if (!format)
        return say(buffer.type.empty()
                       ? ", which has no type; write one of float, int, uint, vectors and matrices"
                       : fmt::format(", which holds {}; only float, int, uint, vectors and matrices of them "
                                     "can be read as a texture",
                                     buffer.type));
    const bool isImage = uniform.type.base == BaseType::image;
    const auto declared = isImage ? imageFormatOf(interface, uniform) : std::nullopt;
    if (const std::string why = sizeProblem(declared, format); !why.empty()) return say(why);
    const std::string fitting = fmt::format(
        "{}{}Buffer", prefixOf(texelsOfFormat(declared ? declared : format)), isImage ? "image" : "sampler");
    if (fitting != uniform.type.word)
        return say(fmt::format(", which holds {}; write {}", buffer.type, fitting));
    return std::nullopt;
}

std::optional<Diagnostic> missingPart(const scene::Scene& scene, const BoundTexture& bound) {
    const scene::Texture& texture = scene.textures[bound.view.texture];
    const auto say = [&](std::string why) {
        return diagnose("draw-E10",
                        fmt::format("{} does not exist: {} (line {})", nameOf(scene, bound.view), why,
                                    texture.place.line),
                        bound.place);
    };
    if (const auto levels = scene::levelsOf(texture);
        bound.view.level && levels && *bound.view.level >= *levels)
        return say(fmt::format("'{}' has {}", texture.name, base::counted(*levels, "level")));
    const int layers = scene::layersOf(texture, bound.view.level.value_or(0)).value_or(0);
    if (bound.view.layer && layers > 0 && *bound.view.layer >= layers)
        return say(fmt::format("'{}' has {}", texture.name, base::counted(layers, "layer")));
    if (bound.view.isPrevious && !texture.hasHistory)
        return say(fmt::format("'{}' is declared without history", texture.name));
    return std::nullopt;
}

/// Rectangles have one level and do not repeat.
void makeFitForRectangle(base::SamplerState& sampler) {
    using enum base::Filter;
    const bool isNearest = sampler.filter == nearestMipmapNearest || sampler.filter == nearestMipmapLinear;
    if (sampler.readsMipmaps()) sampler.filter = isNearest ? nearest : linear;
    std::ranges::replace_if(sampler.wrap, base::repeats, base::Wrap::clampToEdge);
}

}  // namespace

BaseType texelsOf(const scene::Texture& texture) {
    return texelsOfFormat(formatOf(texture));
}

std::string_view prefixOf(BaseType texels) {
    if (texels == BaseType::integer) return "i";
    return texels == BaseType::unsignedInteger ? "u" : "";
}

SamplerType samplerTypeOf(std::string_view word) {
    SamplerType type;
    if (word.starts_with('i') && !word.starts_with("image")) {
        type.texels = BaseType::integer;
        word.remove_prefix(1);
    } else if (word.starts_with('u')) {
        type.texels = BaseType::unsignedInteger;
        word.remove_prefix(1);
    }
    for (const std::string_view begin : {std::string_view("sampler"), std::string_view("image")})
        if (word.starts_with(begin)) {
            word.remove_prefix(begin.size());
            break;
        }
    const auto takeEnd = [&](std::string_view end) {
        if (!word.ends_with(end)) return false;
        word.remove_suffix(end.size());
        return true;
    };
    type.isBuffer = word == "Buffer";
    type.isShadow = takeEnd("Shadow");
    if (word == "2DMS" || word == "2DMSArray") {
        type.isMultisampled = true;
        type.target = word == "2DMS" ? TextureTarget::texture2D : TextureTarget::texture2DArray;
    }
    for (const Dimension& each : kDimensions)
        if (each.word == word) type.target = each.target;
    return type;
}

std::optional<base::TexelFormat> imageFormatOf(const ProgramInterface& interface,
                                               const ActiveUniform& uniform) {
    const auto declared = interface.facts.memory.images.find(std::string(rootName(uniform.name)));
    if (declared == interface.facts.memory.images.end()) return std::nullopt;
    return base::texelFormatNamed(declared->second.format);
}

std::string nameOf(const scene::Scene& scene, const scene::TextureView& view) {
    const scene::Texture& texture = scene.textures[view.texture];
    std::string text = texture.name;
    if (view.isPrevious) text += ".prev";
    if (view.level) text += fmt::format(".level({})", *view.level);
    if (view.layer && texture.target == TextureTarget::cubeArray)
        text += fmt::format(".layer({}).face({})", *view.layer / 6, *view.layer % 6);
    else if (view.layer)
        text += fmt::format(".{}({})", texture.target == TextureTarget::cube ? "face" : "layer", *view.layer);
    return "'" + text + "'";
}

std::optional<Diagnostic> bindingProblem(const scene::Scene& scene, const ProgramInterface& interface,
                                         const ActiveUniform& uniform, const BoundTexture& bound) {
    if (bound.buffer.buffer) return bufferProblem(scene, interface, uniform, bound);
    if (auto missing = missingPart(scene, bound)) return missing;
    const scene::Texture& texture = scene.textures[bound.view.texture];
    const auto say = [&](const std::string& advice) {
        return diagnose("draw-E09",
                        fmt::format("{} '{}'{} cannot read {} (line {}), which is {}{}", uniform.type.word,
                                    uniform.name, placeOf(interface, uniform), nameOf(scene, bound.view),
                                    texture.place.line, describeView(texture, bound.view), advice),
                        bound.place);
    };
    if (!uniform.type.isOpaque()) return say("; write the name at a sampler or image");
    const SamplerType type = samplerTypeOf(uniform.type.word);
    const bool isImage = uniform.type.base == BaseType::image;
    const auto format = formatOf(texture);
    if (isImage && (texture.isSrgb || (format && !base::isImageFormat(*format))))
        return say("; images take neither depth nor sRGB");
    if (isImage && texture.samples > 1) return say("; images take no samples");
    const auto declared = isImage ? imageFormatOf(interface, uniform) : std::nullopt;
    if (const std::string why = sizeProblem(declared, format); !why.empty()) return say(why);
    const std::string fitting = fittingWord(texture, bound.view, isImage, type, declared);
    if (fitting != uniform.type.word) return say("; write " + fitting);
    return std::nullopt;
}

void useNamed(const scene::Scene& scene, const scene::TextureView& view, const ValueType& type,
              TextureUse& use) {
    const scene::Texture& texture = scene.textures[view.texture];
    const SamplerType asked = samplerTypeOf(type.word);
    use.view = view;
    use.target = targetOf(texture, view);
    use.readsSamples = asked.isMultisampled;
    use.compares = asked.isShadow;
    use.sampler = view.sampler ? scene.samplers[view.sampler].state : texture.sampler;
    if (texelsOf(texture) != BaseType::floating)
        use.sampler.filter =
            use.sampler.readsMipmaps() ? base::Filter::nearestMipmapNearest : base::Filter::nearest;
    // A depth texture has its wrapping, stated or not.
    if (use.compares && view.sampler && !scene.samplers[view.sampler].statesWrap) {
        use.sampler.wrap.fill(base::Wrap::clampToBorder);
        use.sampler.border.fill(base::farthestDepth(use.sampler.compare));
    }
    if (texture.target == TextureTarget::cube || texture.target == TextureTarget::cubeArray)
        use.sampler.wrap.fill(base::Wrap::clampToEdge);
    if (texture.target == TextureTarget::rectangle) makeFitForRectangle(use.sampler);
}

std::optional<base::TexelFormat> texelsOfType(std::string_view type) {
    using enum base::TexelFormat;
    struct Row {
        std::string_view type;
        base::TexelFormat texels;
    };
    static constexpr Row kRows[] = {
        {"float", r32f},     {"vec2", rg32f},     {"vec3", rgba32f},  {"vec4", rgba32f}, {"int", r32i},
        {"ivec2", rg32i},    {"ivec3", rgba32i},  {"ivec4", rgba32i}, {"uint", r32ui},   {"uvec2", rg32ui},
        {"uvec3", rgba32ui}, {"uvec4", rgba32ui}, {"mat2", rg32f},    {"mat3", rgba32f}, {"mat4", rgba32f},
    };
    for (const Row& each : kRows)
        if (each.type == type) return each.texels;
    return std::nullopt;
}

void useBuffer(const scene::Scene& scene, const scene::BufferView& view, TextureUse& use) {
    use.buffer = view;
    use.bufferFormat = texelsOfType(scene.buffers[view.buffer].type).value_or(use.bufferFormat);
}

bool readsPart(const scene::Scene& scene, const TextureUse& use, const scene::TextureView& target) {
    if (use.view.texture != target.texture || use.view.isPrevious != target.isPrevious) return false;
    if (use.view.layer && target.layer && *use.view.layer != *target.layer) return false;
    const int drawn = target.level.value_or(0);
    if (use.view.level) return *use.view.level == drawn;
    if (!use.sampler.readsMipmaps()) return drawn == 0;
    return drawn < scene::levelsOf(scene.textures[target.texture]).value_or(drawn + 1);
}

}  // namespace glibra::plan
