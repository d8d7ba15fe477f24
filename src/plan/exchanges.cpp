// Which copies of objects with history change their places before a node, and which of them begin with the
// content of the other copy.

#include <algorithm>
#include <set>

#include "plan/accesses.h"

namespace glibra::plan {
namespace {

/// Finds the objects that a dispatch writes whole, as far as the text of its shader shows it.
class WholeWrites {
  public:
    WholeWrites(const scene::Scene& scene, const FramePlan& plan, const PlannedDispatch& dispatch)
        : scene_(scene), program_(plan.programs[dispatch.program]), textures_(dispatch.textures) {}

    [[nodiscard]] std::optional<PlannedExchange::Whole> find(const Object& object) const {
        if (!program_.interface->usable || usesOfCurrent(object) != 1) return std::nullopt;
        for (const glsl::WholeWrite& each : program_.interface->facts.wholeWrites) {
            const std::optional<scene::ObjectView> written =
                each.isBlock ? blockNamed(each.name) : textureNamed(each.name, true);
            if (!written || objectOf(*written) != object || !isWhole(*written)) continue;
            PlannedExchange::Whole whole{each.axes, {}};
            for (const std::string& name : each.sizes) {
                std::optional<scene::ObjectView> sized = textureNamed(name, false);
                if (!sized) sized = blockNamed(name);
                if (!sized) return std::nullopt;
                whole.sizes.push_back(*sized);
            }
            return whole;
        }
        return std::nullopt;
    }

  private:
    /// How often the program uses the current copy.
    [[nodiscard]] std::ptrdiff_t usesOfCurrent(const Object& object) const {
        const std::vector<ObjectUse> uses = shaderUses(program_, textures_);
        return std::ranges::count_if(uses, [&](const ObjectUse& each) {
            return objectOf(each.object) == object && !isPreviousCopy(each.object);
        });
    }
    /// The texture of a uniform that is no array.
    [[nodiscard]] std::optional<scene::ObjectView> textureNamed(const std::string& name, bool isImage) const {
        for (const TextureUse& each : textures_) {
            const base::ActiveUniform& uniform = at(program_.interface->uniforms, each.uniform);
            if (uniform.name != name || uniform.isArray || !each.view.texture) continue;
            if (!isImage) return each.view;
            // A format of other texels is ignored when the image is bound, and its stores may get lost.
            const auto* empty = std::get_if<scene::EmptySource>(&scene_.textures[each.view.texture].source);
            const bool fits = empty != nullptr &&
                              (!each.imageFormat ||
                               base::bytesPerTexel(*each.imageFormat) == base::bytesPerTexel(empty->format));
            return each.isImage && fits ? std::optional<scene::ObjectView>(each.view) : std::nullopt;
        }
        return std::nullopt;
    }
    [[nodiscard]] std::optional<scene::ObjectView> blockNamed(const std::string& name) const {
        for (const BlockUse& each : program_.blocks)
            if (each.kind == BlockUse::Kind::storage &&
                program_.interface->storageBlocks.at(each.index).name == name)
                return each.buffer;
        return std::nullopt;
    }
    [[nodiscard]] bool isWhole(const scene::ObjectView& view) const {
        if (isPreviousCopy(view)) return false;
        const auto* texture = std::get_if<scene::TextureView>(&view);
        if (texture == nullptr) return true;
        const scene::Texture& of = scene_.textures[texture->texture];
        return !texture->level && !texture->layer && of.levels == 1 && of.samples == 1;
    }

    const scene::Scene& scene_;
    const PlannedProgram& program_;
    const std::vector<TextureUse>& textures_;
};

/// True if a draw of the pass gives each texel of the target a new colour.
bool isFilledWhole(const scene::Scene& scene, const FramePlan& plan, const PlannedPass& planned,
                   const Object& object) {
    const scene::Pass& pass = plan.passOf(planned);
    const auto found =
        std::ranges::find_if(pass.targets, [&](scene::TextureIndex each) { return Object(each) == object; });
    if (found == pass.targets.end()) return false;
    const auto index = static_cast<std::size_t>(found - pass.targets.begin());
    const scene::Texture& target = scene.textures[*found];
    const auto* empty = std::get_if<scene::EmptySource>(&target.source);
    const bool isPlane = empty != nullptr && target.target == scene::TextureTarget::texture2D &&
                         target.levels == 1 && target.samples == 1;
    if (!isPlane || (!pass.parts.empty() && pass.parts[index] != scene::TargetPart{})) return false;
    return std::ranges::any_of(planned.steps, [&](const auto& step) {
        const auto* drawn = std::get_if<PlannedDraw>(&step);
        if (drawn == nullptr) return false;
        const scene::Draw& draw = plan.drawOf(*drawn);
        const ProgramInterface& program = *plan.programs[drawn->program].interface;
        if (!draw.isFill || !program.usable || !program.facts.suppliesVertexStage || drawn->unwritten.any() ||
            program.facts.stages.empty() || program.facts.stages.back().facts.mayLeaveFragments)
            return false;
        scene::RasterState plain;
        plain.depthTest = plain.depthWrite = false;
        return draw.raster == plain && draw.instances == 1 && !draw.instancesFrom;
    });
}

}  // namespace

std::vector<PlannedExchange> exchangesOf(const scene::Scene& scene, const FramePlan& plan,
                                         const scene::NodeIndex& node, const NodeAccess& access,
                                         bool everything) {
    std::vector<PlannedExchange> exchanges;
    std::set<Object> done;
    for (const ObjectUse& each : access.uses) {
        const Object object = objectOf(each.object);
        if (!each.writes || isPreviousCopy(each.object) || !hasHistory(scene, object)) continue;
        if (!done.insert(object).second) continue;
        PlannedExchange exchange{object, !access.overwritten.contains(object)};
        if (node.kind == scene::NodeIndex::Kind::dispatch) {
            const PlannedDispatch& planned = plan.dispatches[node.index];
            if (plan.dispatchOf(planned).discards) exchange.keepsContent = false;
            if (exchange.keepsContent && !everything)
                exchange.whole = WholeWrites(scene, plan, planned).find(object);
        } else if (node.kind == scene::NodeIndex::Kind::pass && exchange.keepsContent && !everything) {
            exchange.isFilled = isFilledWhole(scene, plan, plan.passes[node.index], object);
        }
        exchanges.push_back(std::move(exchange));
    }
    return exchanges;
}

}  // namespace glibra::plan
