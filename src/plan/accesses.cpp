#include "plan/accesses.h"

#include <fmt/format.h>

#include <algorithm>
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
    if (found == images.end()) return {object, true, true};
    return {object, !found->second.isWriteonly, !found->second.isReadonly};
}

ObjectUse blockUseOf(const PlannedProgram& program, const BlockUse& use) {
    if (use.kind == BlockUse::Kind::uniform) return {use.buffer, true, false};
    if (use.kind == BlockUse::Kind::counters) return {use.buffer, true, true};
    const std::string_view name = program.interface->storageBlocks.at(use.index).name;
    const glsl::MemoryBlock* block =
        program.interface->facts.memory.block(name.substr(0, name.find('[')), true);
    if (block == nullptr) return {use.buffer, true, true};
    return {use.buffer, !block->isWriteonly, !block->isReadonly};
}

void addDraw(const FramePlan& plan, const PlannedDraw& planned, std::vector<ObjectUse>& to) {
    const std::vector<ObjectUse> own = shaderUses(plan.programs[planned.program], planned.textures);
    to.insert(to.end(), own.begin(), own.end());
    const auto read = [&](const scene::BufferView& view) {
        if (view.buffer) to.push_back({view, true, false});
    };
    for (const scene::BufferView& each : plan.drawOf(planned).ownBuffers()) read(each);
    if (!planned.inputs) return;
    for (const InputSource& each : plan.inputs[planned.inputs].sources)
        if (const auto* view = std::get_if<scene::BufferView>(&each.from)) read(*view);
}

void addPass(const FramePlan& plan, const PlannedPass& planned, std::vector<ObjectUse>& to) {
    const scene::Pass& pass = plan.passOf(planned);
    for (std::size_t i = 0; i < pass.targets.size(); ++i)
        to.push_back({scene::TextureView{.texture = pass.targets[i]},
                      i >= pass.clearColors.size() || !pass.clearColors[i], true});
    if (pass.depth) to.push_back({*pass.depth, !pass.clearDepth, true});
    for (const auto& step : planned.steps)
        if (const auto* draw = std::get_if<PlannedDraw>(&step)) addDraw(plan, *draw, to);
}

}  // namespace

std::vector<ObjectUse> shaderUses(const PlannedProgram& program, const std::vector<TextureUse>& textures) {
    std::vector<ObjectUse> uses;
    for (const TextureUse& each : textures)
        if (each.view.texture || each.buffer.buffer) uses.push_back(textureUseOf(program, each));
    for (const BlockUse& each : program.blocks) uses.push_back(blockUseOf(program, each));
    return uses;
}

bool readsCamera(const PlannedProgram& program) {
    using glsl::Builtin;
    const auto isOfCamera = [](const UniformBinding& each) {
        const auto* supplied = std::get_if<Supplied>(&each.value);
        if (supplied == nullptr) return false;
        switch (supplied->value) {
            case Builtin::timer:
            case Builtin::noise2:
            case Builtin::noise3:
            case Builtin::currentColor:
            case Builtin::pointSize:
            case Builtin::textureMatrix:
            case Builtin::textureMatrixInverse:
            case Builtin::textureMatrixTranspose:
            case Builtin::textureMatrixInverseTranspose:
                return false;
            default:
                return true;
        }
    };
    return program.interface->facts.suppliesVertexStage &&
           std::any_of(program.values.begin(), program.values.end(), isOfCamera);
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

std::vector<ObjectUse> usesOf(const FramePlan& plan, std::size_t node) {
    std::vector<ObjectUse> uses;
    const scene::NodeIndex& at = plan.order.at(node);
    if (at.kind == scene::NodeIndex::Kind::pass) {
        addPass(plan, plan.passes.at(at.index), uses);
    } else if (at.kind == scene::NodeIndex::Kind::dispatch) {
        const PlannedDispatch& planned = plan.dispatches.at(at.index);
        uses = shaderUses(plan.programs[planned.program], planned.textures);
        if (const auto* groups = std::get_if<scene::GroupsFrom>(&plan.dispatchOf(planned).groups))
            uses.push_back({groups->first.buffer, true, false});
    } else {
        const scene::ClearObject& clear = plan.clearOf(plan.clears.at(at.index));
        if (const auto* buffer = std::get_if<scene::BufferIndex>(&clear.object))
            uses.push_back({scene::BufferView{*buffer}, false, true});
        else
            uses.push_back(
                {scene::TextureView{.texture = std::get<scene::TextureIndex>(clear.object)}, false, true});
    }
    return uses;
}

Object objectOf(const scene::ObjectView& view) {
    if (const auto* buffer = std::get_if<scene::BufferView>(&view)) return buffer->buffer;
    return std::get<scene::TextureView>(view).texture;
}

bool hasHistory(const scene::Scene& scene, const Object& object) {
    if (const auto* buffer = std::get_if<scene::BufferIndex>(&object))
        return scene.buffers[*buffer].hasHistory;
    return scene.textures[std::get<scene::TextureIndex>(object)].hasHistory;
}

std::set<Object> overwritten(const scene::Scene& scene, const FramePlan& plan, std::size_t at) {
    const scene::NodeIndex& node = plan.order.at(at);
    std::set<Object> objects;
    if (node.kind == scene::NodeIndex::Kind::clear)
        std::visit([&](auto index) { objects.insert(index); },
                   plan.clearOf(plan.clears.at(node.index)).object);
    if (node.kind != scene::NodeIndex::Kind::pass) return objects;
    const scene::Pass& pass = plan.passOf(plan.passes.at(node.index));
    const auto isWhole = [&](scene::TextureIndex texture, const scene::TargetPart& part) {
        return !part.layer && scene.textures[texture].levels == 1;
    };
    for (std::size_t i = 0; i < pass.targets.size() && i < pass.clearColors.size(); ++i)
        if (pass.clearColors[i] &&
            isWhole(pass.targets[i], i < pass.parts.size() ? pass.parts[i] : scene::TargetPart{}))
            objects.insert(pass.targets[i]);
    if (pass.depth && pass.clearDepth && isWhole(pass.depth->texture, {pass.depth->level, pass.depth->layer}))
        objects.insert(pass.depth->texture);
    return objects;
}

void findBeginnings(const scene::Scene& scene, FramePlan& plan) {
    std::set<Object> fresh;    // their content is of this frame
    std::set<Object> touched;  // read or written before that
    std::set<Object> written;
    for (std::size_t node = 0; node < plan.order.size(); ++node) {
        const std::set<Object> covered = overwritten(scene, plan, node);
        for (const ObjectUse& each : usesOf(plan, node)) {
            const Object object = objectOf(each.object);
            if (each.writes) written.insert(object);
            const bool isRead = each.reads && !(each.writes && covered.contains(object));
            if (!fresh.contains(object) && (isRead || !covered.contains(object))) touched.insert(object);
        }
        fresh.insert(covered.begin(), covered.end());
    }
    const auto add = [](std::vector<scene::ObjectView>& to, const Object& object) {
        if (const auto* buffer = std::get_if<scene::BufferIndex>(&object))
            to.emplace_back(scene::BufferView{*buffer});
        else
            to.emplace_back(scene::TextureView{.texture = std::get<scene::TextureIndex>(object)});
    };
    for (const Object& each : written) {
        const auto* texture = std::get_if<scene::TextureIndex>(&each);
        if (touched.contains(each) || hasHistory(scene, each))
            add(plan.resets, each);
        else if (texture != nullptr)
            plan.cleared.push_back(*texture);
    }
    for (const Object& each : touched)
        if (!written.contains(each)) add(plan.reads, each);
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
        for (const ObjectUse& each : usesOf(plan, node)) {
            const auto* view = std::get_if<scene::TextureView>(&each.object);
            const auto life = view != nullptr ? lives.find(view->texture) : lives.end();
            if (life == lives.end()) continue;
            life->second.first = std::min(life->second.first, node);
            life->second.last = node;
        }
    std::vector<Life> inOrder;
    for (const auto& [texture, life] : lives) inOrder.push_back(life);
    std::stable_sort(inOrder.begin(), inOrder.end(),
                     [](const Life& a, const Life& b) { return a.first < b.first; });
    const auto haveOneLayout = [&](scene::TextureIndex a, scene::TextureIndex b) {
        const scene::Texture &one = scene.textures[a], &other = scene.textures[b];
        return one.target == other.target && one.levels == other.levels &&
               one.hasMipmaps == other.hasMipmaps &&
               std::get<scene::EmptySource>(one.source) == std::get<scene::EmptySource>(other.source);
    };
    std::map<scene::TextureIndex, scene::TextureIndex> sharing;
    std::vector<Life> memories;  // with the last use of each so far
    for (const Life& life : inOrder) {
        const auto free = std::find_if(memories.begin(), memories.end(), [&](const Life& each) {
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
    return std::any_of(textures.begin(), textures.end(),
                       [&](const TextureUse& each) { return textureUseOf(program, each).writes; }) ||
           std::any_of(program.blocks.begin(), program.blocks.end(),
                       [&](const BlockUse& each) { return blockUseOf(program, each).writes; });
}

bool writesMemory(const glsl::TranslatedProgram& program) {
    return std::any_of(program.stages.begin(), program.stages.end(),
                       [](const glsl::TranslatedStage& each) { return each.facts.writesMemory; });
}

}  // namespace glibra::plan
