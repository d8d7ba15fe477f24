#include "plan/accesses.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "plan/submission.h"
#include "plan/texture_binding.h"
#include "plan/uniform_names.h"

namespace glibra::plan {
namespace {

ObjectUse textureUseOf(const PlannedProgram& program, const TextureUse& use) {
    const scene::ObjectView object =
        use.buffer.buffer ? scene::ObjectView(use.buffer) : scene::ObjectView(use.view);
    if (!use.isImage) return {object, true, false};
    const auto& images = program.interface->facts.memory.images;
    const auto found = images.find(at(program.interface->uniforms, use.uniform).name);
    if (found == images.end()) return {object, true, true, true};
    return {object, !found->second.isWriteonly, !found->second.isReadonly, !found->second.isReadonly};
}

ObjectUse blockUseOf(const PlannedProgram& program, const BlockUse& use) {
    if (use.kind == BlockUse::Kind::uniform) return {use.buffer, true, false};
    if (use.kind == BlockUse::Kind::counters) return {use.buffer, true, true, true};
    const std::string_view name = program.interface->storageBlocks.at(use.index).name;
    const glsl::MemoryBlock* block =
        program.interface->facts.memory.block(name.substr(0, name.find('[')), true);
    if (block == nullptr) return {use.buffer, true, true, true};
    return {use.buffer, !block->isWriteonly, !block->isReadonly, !block->isReadonly};
}

NodeAccess accessOf(const scene::Scene& scene, const FramePlan& plan, const PlannedPass& planned) {
    NodeAccess access;
    const scene::Pass& pass = plan.passOf(planned);
    const auto clears = [&](scene::TextureIndex texture, const scene::TargetPart& part) {
        if (!part.layer && scene.textures[texture].levels == 1) access.overwritten.insert(texture);
    };
    for (std::size_t i = 0; i < pass.targets.size(); ++i) {
        const bool isCleared = i < pass.clearColors.size() && pass.clearColors[i];
        access.uses.push_back({scene::TextureView{.texture = pass.targets[i]}, !isCleared, true});
        if (isCleared) clears(pass.targets[i], i < pass.parts.size() ? pass.parts[i] : scene::TargetPart{});
    }
    if (pass.depth) {
        access.uses.push_back({*pass.depth, !pass.clearDepth, true});
        if (pass.clearDepth) clears(pass.depth->texture, {pass.depth->level, pass.depth->layer});
    }
    for (const auto& step : planned.steps)
        if (const auto* draw = std::get_if<PlannedDraw>(&step)) {
            const std::vector<ObjectUse> own =
                usesOf(plan.programs[draw->program], draw->textures, plan.drawOf(*draw),
                       draw->inputs ? &plan.inputs[draw->inputs] : nullptr);
            access.uses.insert(access.uses.end(), own.begin(), own.end());
        }
    return access;
}

scene::ObjectView viewOf(const Object& object) {
    if (const auto* buffer = std::get_if<scene::BufferIndex>(&object)) return scene::BufferView{*buffer};
    return scene::TextureView{.texture = std::get<scene::TextureIndex>(object)};
}

}  // namespace

std::vector<ObjectUse> shaderUses(const PlannedProgram& program, const std::vector<TextureUse>& textures) {
    std::vector<ObjectUse> uses;
    for (const TextureUse& each : textures)
        if (each.view.texture || each.buffer.buffer) uses.push_back(textureUseOf(program, each));
    for (const BlockUse& each : program.blocks) uses.push_back(blockUseOf(program, each));
    return uses;
}

std::vector<ObjectUse> usesOf(const PlannedProgram& program, const std::vector<TextureUse>& textures,
                              const scene::Draw& draw, const PlannedInputs* inputs) {
    std::vector<ObjectUse> uses = shaderUses(program, textures);
    const auto read = [&](const scene::BufferView& view) {
        if (view.buffer) uses.push_back({view});
    };
    for (const scene::BufferView& each : draw.ownBuffers()) read(each);
    if (inputs == nullptr) return uses;
    for (const InputSource& each : inputs->sources)
        if (const auto* view = std::get_if<scene::BufferView>(&each.from)) read(*view);
    return uses;
}

std::vector<ObjectUse> usesOf(const PlannedProgram& program, const std::vector<TextureUse>& textures,
                              const scene::Dispatch& dispatch) {
    std::vector<ObjectUse> uses = shaderUses(program, textures);
    if (const auto* groups = std::get_if<scene::GroupsFrom>(&dispatch.groups))
        uses.push_back({groups->first.buffer});
    return uses;
}

bool readsCamera(const PlannedProgram& program) {
    using enum glsl::Builtin;
    constexpr std::array kOthers{timer, noise2, noise3, currentColor, pointSize};
    const auto isOfCamera = [&](const UniformBinding& each) {
        const auto* supplied = std::get_if<Supplied>(&each.value);
        return supplied != nullptr && !isTextureMatrix(supplied->value) &&
               std::ranges::find(kOthers, supplied->value) == kOthers.end();
    };
    return program.interface->facts.suppliesVertexStage && std::ranges::any_of(program.values, isOfCamera);
}

Diagnostics readsOfWritten(const scene::Scene& scene, const PlannedProgram& program,
                           const std::vector<TextureUse>& textures, const std::string& word,
                           const Place& place) {
    Diagnostics problems;
    std::set<scene::TextureIndex> seen;
    const auto nameOfUniform = [&](const TextureUse& use) {
        return userNameOf(*program.interface, at(program.interface->uniforms, use.uniform).name);
    };
    for (const TextureUse& image : textures) {
        if (!image.isImage || !image.view.texture || !textureUseOf(program, image).writes) continue;
        for (const TextureUse& sampler : textures) {
            const scene::Texture& texture = scene.textures[image.view.texture];
            if (sampler.isImage || texture.name.empty() || !readsPart(scene, sampler, image.view) ||
                !seen.insert(image.view.texture).second)
                continue;
            problems.push_back(diagnose(
                "draw-W12",
                fmt::format(
                    "{}: sampler '{}' reads {} while image '{}' writes it; unless each invocation reads only "
                    "the texel that it writes, declare '{}' with history and read '{}.prev'",
                    word, nameOfUniform(sampler), nameOf(scene, image.view), nameOfUniform(image),
                    texture.name, texture.name),
                place));
        }
    }
    return problems;
}

std::vector<NodeAccess> accessesOf(const scene::Scene& scene, const FramePlan& plan, bool everything) {
    std::vector<NodeAccess> accesses;
    for (const scene::NodeIndex& node : plan.order) {
        NodeAccess& access = accesses.emplace_back();
        if (node.kind == scene::NodeIndex::Kind::pass) {
            access = accessOf(scene, plan, plan.passes.at(node.index));
        } else if (node.kind == scene::NodeIndex::Kind::dispatch) {
            const PlannedDispatch& planned = plan.dispatches.at(node.index);
            access.uses = usesOf(plan.programs[planned.program], planned.textures, plan.dispatchOf(planned));
        } else {
            const Object& cleared = plan.clearOf(plan.clears.at(node.index)).object;
            access.uses = {{viewOf(cleared), false, true}};
            access.overwritten = {cleared};
        }
        for (const ObjectUse& each : access.uses)
            if (each.writes) access.written.insert(objectOf(each.object));
        access.exchanges = exchangesOf(scene, plan, node, access, everything);
    }
    return accesses;
}

Object objectOf(const scene::ObjectView& view) {
    if (const auto* buffer = std::get_if<scene::BufferView>(&view)) return buffer->buffer;
    return std::get<scene::TextureView>(view).texture;
}

bool isPreviousCopy(const scene::ObjectView& view) {
    return std::visit([](const auto& each) { return each.isPrevious; }, view);
}

bool hasHistory(const scene::Scene& scene, const Object& object) {
    if (const auto* buffer = std::get_if<scene::BufferIndex>(&object))
        return scene.buffers[*buffer].hasHistory;
    return scene.textures[std::get<scene::TextureIndex>(object)].hasHistory;
}

void findBeginnings(const scene::Scene& scene, FramePlan& plan) {
    std::set<Object> fresh;    // their content is of this frame
    std::set<Object> touched;  // read or written before that
    std::set<Object> written;
    for (const NodeAccess& node : plan.accesses) {
        for (const ObjectUse& each : node.uses) {
            const Object object = objectOf(each.object);
            const bool isCovered = node.overwritten.contains(object);
            const bool isRead = each.reads && !(each.writes && isCovered);
            if (!fresh.contains(object) && (isRead || !isCovered)) touched.insert(object);
        }
        written.insert(node.written.begin(), node.written.end());
        fresh.insert(node.overwritten.begin(), node.overwritten.end());
    }
    for (const Object& each : written) {
        const auto* texture = std::get_if<scene::TextureIndex>(&each);
        if (scene.goesOn && touched.contains(each))
            plan.showsEarlierFrames = true;
        else if (touched.contains(each) || hasHistory(scene, each))
            plan.resets.push_back(viewOf(each));
        else if (texture != nullptr)
            plan.cleared.push_back(*texture);
    }
    if (scene.goesOn) return;
    for (const Object& each : touched)
        if (!written.contains(each)) plan.reads.push_back(viewOf(each));
}

std::map<scene::TextureIndex, scene::TextureIndex> sharedTargets(
    const scene::Scene& scene, const FramePlan& plan, const std::vector<scene::ObjectView>& roots) {
    struct Life {
        scene::TextureIndex texture;
        std::size_t first = 0, last = 0;  ///< nodes that use it
    };
    std::map<scene::TextureIndex, Life> lives;
    for (const scene::TextureIndex each : plan.cleared)
        if (std::holds_alternative<scene::EmptySource>(scene.textures[each].source) &&
            scene.textures[each].samples == 1)
            lives.emplace(each, Life{each, plan.order.size(), 0});
    for (const scene::ObjectView& each : roots)
        if (const auto* view = std::get_if<scene::TextureView>(&each)) lives.erase(view->texture);
    for (std::size_t node = 0; node < plan.order.size(); ++node)
        for (const ObjectUse& each : plan.accesses[node].uses) {
            const auto* view = std::get_if<scene::TextureView>(&each.object);
            const auto life = view != nullptr ? lives.find(view->texture) : lives.end();
            if (life == lives.end()) continue;
            life->second.first = std::min(life->second.first, node);
            life->second.last = node;
        }
    std::vector<Life> inOrder;
    for (const auto& [texture, life] : lives) inOrder.push_back(life);
    std::ranges::stable_sort(inOrder, [](const Life& a, const Life& b) { return a.first < b.first; });
    const auto haveOneLayout = [&](scene::TextureIndex a, scene::TextureIndex b) {
        const scene::Texture &one = scene.textures[a], &other = scene.textures[b];
        return one.target == other.target && one.levels == other.levels &&
               one.hasMipmaps == other.hasMipmaps &&
               std::get<scene::EmptySource>(one.source) == std::get<scene::EmptySource>(other.source);
    };
    std::map<scene::TextureIndex, scene::TextureIndex> sharing;
    std::vector<Life> memories;  // with the last use of each so far
    for (const Life& life : inOrder) {
        const auto free = std::ranges::find_if(memories, [&](const Life& each) {
            return each.last < life.first && haveOneLayout(each.texture, life.texture);
        });
        if (free == memories.end()) {
            memories.push_back(life);
            continue;
        }
        sharing.emplace(life.texture, free->texture);
        free->last = life.last;
    }
    return sharing;
}

bool writesMemory(const PlannedProgram& program, const std::vector<TextureUse>& textures) {
    return std::ranges::any_of(textures,
                               [&](const TextureUse& each) { return textureUseOf(program, each).writes; }) ||
           std::ranges::any_of(program.blocks,
                               [&](const BlockUse& each) { return blockUseOf(program, each).writes; });
}

PaintedEdges paintedEdges(const PlannedProgram& program, const std::vector<TextureUse>& textures) {
    const auto& stages = program.interface->facts.stages;
    if (std::ranges::none_of(stages,
                             [](const glsl::TranslatedStage& each) { return each.facts.mayPaintEdges; }))
        return PaintedEdges::none;
    return writesMemory(program, textures) ? PaintedEdges::perPixel : PaintedEdges::shown;
}

bool writesMemory(const glsl::TranslatedProgram& program) {
    return std::ranges::any_of(program.stages,
                               [](const glsl::TranslatedStage& each) { return each.facts.writesMemory; });
}

// Which copies of objects with history change their places before a node, and which of them begin with the
// content of the other copy.

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
        return *draw.raster == plain && draw.instances == 1 && !draw.instancesFrom;
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
