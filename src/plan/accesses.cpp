#include "plan/accesses.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

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
        if (touched.contains(each) || hasHistory(scene, each))
            plan.resets.push_back(viewOf(each));
        else if (texture != nullptr)
            plan.cleared.push_back(*texture);
    }
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

}  // namespace glibra::plan
