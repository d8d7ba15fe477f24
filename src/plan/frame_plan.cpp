#include "plan/frame_plan.h"

#include <fmt/format.h>
#include <algorithm>
#include <initializer_list>
#include <ranges>
#include <string_view>

#include "base/suggest.h"
#include "plan/uniform_names.h"

namespace glibra::plan {
namespace {

std::string_view plainName(std::string_view block) {
    return block.substr(0, block.find('['));
}

/// "; did you mean 'particles'?" if a buffer of the scene has a name that is near.
std::string suggestedBuffer(const scene::Scene& scene, std::string_view name) {
    std::vector<std::string_view> names;
    for (const scene::Buffer& each : scene.buffers) names.push_back(each.name);
    return base::suggestion(name, names);
}

}  // namespace

Result<std::vector<BlockUse>> blockUses(const scene::Scene& scene, const scene::Program& program,
                                        scene::UniformSetIndex set, const ProgramInterface& interface) {
    // The buffer that a tag binds, or the one of that name; nothing if there is neither.
    const auto find = [&](std::string_view name) -> std::optional<scene::BufferView> {
        if (name.empty()) return std::nullopt;
        if (set)
            for (const auto& object : std::ranges::reverse_view(scene.uniformSets[set].objects))
                if (const auto* view = std::get_if<scene::BufferView>(&object.object);
                    view != nullptr && object.tag == name)
                    return *view;
        for (const scene::BufferIndex i : scene.buffers.indices())
            if (scene.buffers[i].name == name) return scene::BufferView{i, false};
        return std::nullopt;
    };
    std::vector<BlockUse> uses;
    Diagnostics errors;
    // A tag whose value is a word that names nothing.
    const auto isLost = [&](std::initializer_list<std::string_view> names) {
        for (const glib::UniformSpec& each : program.uniforms) {
            if (each.word.empty() || !each.values.empty() ||
                std::ranges::find(names, each.tag) == names.end())
                continue;
            const glib::Position at = each.valuePosition;
            errors.push_back(unknownWord(scene, each.word, {program.place.file, at.line, at.column}));
            return true;
        }
        return false;
    };
    const auto addBlock = [&](BlockUse::Kind kind, std::size_t index, const std::string& name) {
        const bool isStorage = kind == BlockUse::Kind::storage;
        const glsl::MemoryBlock* declared = interface.facts.memory.block(plainName(name), isStorage);
        const Place place = declared != nullptr ? declared->place : program.place;
        std::optional<scene::BufferView> view = find(name);
        if (!view) view = find(plainName(name));
        if (!view && declared != nullptr && !declared->instance.empty() && !plainName(name).empty()) {
            view = find(declared->instance + name.substr(plainName(name).size()));
            if (!view) view = find(declared->instance);
        }
        if (!view && isStorage && declared != nullptr && !declared->members.empty())
            view = find(declared->members.back().name);
        if (isLost({name, plainName(name), declared != nullptr ? std::string_view(declared->instance) : "",
                    declared != nullptr && isStorage && !declared->members.empty()
                        ? std::string_view(declared->members.back().name)
                        : ""}))
            return;
        if (view) return uses.push_back({kind, index, *view, place});
        if (isStorage)
            errors.push_back(diagnose(
                "memory-E02",
                fmt::format("storage block '{}' of program '{}' has no buffer; write 'Buffer {} n' before "
                            "the program, or give the tag '{}' a buffer{}",
                            name, program.name, plainName(name), plainName(name),
                            suggestedBuffer(scene, plainName(name))),
                program.place));
    };
    for (std::size_t i = 0; i < interface.blocks.size(); ++i)
        addBlock(BlockUse::Kind::uniform, i, interface.blocks[i].name);
    for (std::size_t i = 0; i < interface.storageBlocks.size(); ++i)
        addBlock(BlockUse::Kind::storage, i, interface.storageBlocks[i].name);
    for (std::size_t i = 0; i < interface.counterBuffers.size(); ++i) {
        const base::CounterBuffer& counters = interface.counterBuffers[i];
        std::optional<scene::BufferView> view;
        std::string from;  // the counter that has it
        for (const std::string& each : counters.counters) {
            const std::optional<scene::BufferView> own = find(each);
            if (own && view && *own != *view)
                errors.push_back(diagnose(
                    "memory-E14",
                    fmt::format("atomic counters '{}' and '{}' of program '{}' have the same binding, "
                                "so they lie in one buffer, but two are given, '{}' and '{}'; give "
                                "each counter a binding of its own",
                                from, each, program.name, scene.buffers[view->buffer].name,
                                scene.buffers[own->buffer].name),
                    program.place));
            if (own && !view) {
                view = own;
                from = each;
            }
        }
        const std::string name = counters.counters.empty() ? std::string() : counters.counters.front();
        const auto declared = interface.facts.memory.counters.find(name);
        const Place place =
            declared != interface.facts.memory.counters.end() ? declared->second.place : program.place;
        if (isLost({name})) continue;
        if (view)
            uses.push_back({BlockUse::Kind::counters, i, *view, place});
        else
            errors.push_back(diagnose("memory-E02",
                                      fmt::format("atomic counter '{}' of program '{}' has no buffer; write "
                                                  "'Buffer {} uint 1' before the program{}",
                                                  name, program.name, name, suggestedBuffer(scene, name)),
                                      program.place));
    }
    if (!errors.empty()) return errors;
    return uses;
}

std::string describe(const BlockUse& use, const ProgramInterface& interface) {
    switch (use.kind) {
        case BlockUse::Kind::uniform:
            return fmt::format("uniform block '{}'", interface.blocks.at(use.index).name);
        case BlockUse::Kind::storage:
            return fmt::format("storage block '{}'", interface.storageBlocks.at(use.index).name);
        case BlockUse::Kind::counters:
            break;
    }
    const std::vector<std::string>& names = interface.counterBuffers.at(use.index).counters;
    return fmt::format("atomic counter '{}'", names.empty() ? std::string() : names.front());
}

scene::NodeIndex FramePlan::declared(const scene::NodeIndex& node) const {
    switch (node.kind) {
        case scene::NodeIndex::Kind::pass:
            return {node.kind, passes.at(node.index).pass};
        case scene::NodeIndex::Kind::dispatch:
            return {node.kind, dispatches.at(node.index).dispatch};
        case scene::NodeIndex::Kind::clear:
            break;
    }
    return {node.kind, clears.at(node.index).clear};
}

const Place& FramePlan::placeOf(const scene::NodeIndex& node) const {
    return nodes->placeOf(declared(node));
}

}  // namespace glibra::plan
