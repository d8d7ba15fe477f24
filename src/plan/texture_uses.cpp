#include "plan/texture_uses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "plan/texture_binding.h"
#include "scene/texture_parts.h"

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

}  // namespace glibra::plan
