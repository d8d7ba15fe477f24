#include "render/draw/memory_order.h"

#include <algorithm>

#include "gpu/object/program.h"

namespace glibra::render {
namespace {

constexpr GLbitfield kStores =
    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_ATOMIC_COUNTER_BARRIER_BIT;
/// Copies, clears, mipmaps and resolved samples.
constexpr GLbitfield kTexelWork = GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT;

GLbitfield wayOf(plan::BlockUse::Kind kind) {
    switch (kind) {
        case plan::BlockUse::Kind::uniform:
            return GL_UNIFORM_BARRIER_BIT;
        case plan::BlockUse::Kind::storage:
            return GL_SHADER_STORAGE_BARRIER_BIT;
        case plan::BlockUse::Kind::counters:
            break;
    }
    return GL_ATOMIC_COUNTER_BARRIER_BIT;
}

GLbitfield waysOf(const plan::PlannedProgram& program, const std::vector<plan::TextureUse>& textures) {
    GLbitfield ways = 0;
    for (const plan::TextureUse& each : textures)
        ways |= each.isImage ? GL_SHADER_IMAGE_ACCESS_BARRIER_BIT : GL_TEXTURE_FETCH_BARRIER_BIT | kTexelWork;
    for (const plan::BlockUse& each : program.blocks) ways |= wayOf(each.kind);
    return ways;
}

void addOnce(std::vector<plan::Object>& to, const plan::Object& object) {
    if (std::ranges::find(to, object) == to.end()) to.push_back(object);
}

}  // namespace

NodeMemory memoryOf(const plan::FramePlan& plan, std::size_t node) {
    NodeMemory memory;
    for (const plan::ObjectUse& each : plan.accesses.at(node).uses) {
        addOnce(memory.touched, plan::objectOf(each.object));
        if (each.stores) addOnce(memory.stored, plan::objectOf(each.object));
    }
    const scene::NodeIndex& at = plan.order.at(node);
    if (at.kind == scene::NodeIndex::Kind::dispatch) {
        const plan::PlannedDispatch& planned = plan.dispatches[at.index];
        memory.ways = waysOf(plan.programs[planned.program], planned.textures);
        if (std::holds_alternative<scene::GroupsFrom>(plan.dispatchOf(planned).groups))
            memory.ways |= GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT;
    } else if (at.kind == scene::NodeIndex::Kind::pass) {
        memory.ways = GL_FRAMEBUFFER_BARRIER_BIT;
        for (const auto& step : plan.passes[at.index].steps) {
            const auto* draw = std::get_if<plan::PlannedDraw>(&step);
            if (draw == nullptr) continue;
            // The counts and indices of a draw may be read back.
            memory.ways |= waysOf(plan.programs[draw->program], draw->textures) |
                           GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT |
                           GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT;
        }
    } else {
        memory.ways = kTexelWork | GL_BUFFER_UPDATE_BARRIER_BIT;
    }
    return memory;
}

MemoryOrder::Used* MemoryOrder::find(const plan::Object& object) {
    const auto found = std::ranges::find_if(used_, [&](const Used& each) { return each.object == object; });
    return found == used_.end() ? nullptr : &*found;
}

void MemoryOrder::before(const NodeMemory& node) {
    GLbitfield needed = 0;
    for (const plan::Object& each : node.touched)
        if (const Used* used = find(each)) needed |= used->stored & node.ways;
    // A store also waits for what read the object before, perhaps in an earlier frame.
    for (const plan::Object& each : node.stored) {
        const Used* used = find(each);
        needed |= (used == nullptr ? GL_ALL_BARRIER_BITS : used->since) & node.ways & kStores;
    }
    if (needed == 0) return;
    glMemoryBarrier(needed);
    for (Used& each : used_) {
        each.since &= ~needed;
        each.stored &= ~needed;
    }
}

void MemoryOrder::after(const NodeMemory& node, bool isOrdered) {
    for (const plan::Object& each : node.touched) {
        Used* used = find(each);
        if (used == nullptr) used = &used_.emplace_back(Used{each});
        used->since = GL_ALL_BARRIER_BITS;
    }
    for (const plan::Object& each : node.stored) find(each)->stored = GL_ALL_BARRIER_BITS;
    if (!isOrdered || node.stored.empty()) return;
    for (Used& each : used_) each.since = each.stored = 0;
}

void MemoryOrder::finish() {
    const bool isOpen = std::ranges::any_of(used_, [](const Used& each) { return each.stored != 0; });
    if (isOpen) gpu::finishShaderWrites();
    used_.clear();
}

}  // namespace glibra::render
