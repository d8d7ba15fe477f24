#include "view/debug_view/frame_items.h"

#include <fmt/format.h>

#include <map>
#include <span>
#include <utility>
#include <variant>

#include "plan/texture_binding.h"
#include "render/gpu_times.h"

namespace glibra::view {
namespace {

std::string nameOfTexture(const scene::Scene& scene, const scene::TextureView& view) {
    const scene::Texture& texture = scene.textures[view.texture];
    std::string name = texture.name.empty() ? fmt::format("unit {}", texture.unit) : texture.name;
    if (view.level) name += fmt::format(" level {}", *view.level);
    if (view.layer) name += fmt::format(" layer {}", *view.layer);
    return name;
}

std::vector<FrameTarget> targetsOf(const scene::Scene& scene, const scene::Pass& pass) {
    using Kind = FrameTarget::Kind;
    std::vector<FrameTarget> targets;
    if (pass.isWindow) targets.push_back({Kind::color, 0, "window"});
    for (std::size_t i = 0; i < pass.targets.size(); ++i) {
        const scene::TargetPart part = i < pass.parts.size() ? pass.parts[i] : scene::TargetPart{};
        const scene::TextureView view{.texture = pass.targets[i], .level = part.level, .layer = part.layer};
        targets.push_back({Kind::color, static_cast<int>(i), nameOfTexture(scene, view), view});
    }
    targets.push_back({Kind::depth, 0, pass.depth ? nameOfTexture(scene, *pass.depth) : "depth",
                       pass.depth.value_or(scene::TextureView{})});
    if (!pass.depth) targets.push_back({Kind::stencil, 0, "stencil"});
    return targets;
}

/// What the shaders of a node write, and what a clear sets to zero.
std::vector<FrameTarget> writtenBy(const scene::Scene& scene, const plan::FramePlan& plan, std::size_t node) {
    std::vector<FrameTarget> targets;
    if (node >= plan.accesses.size()) return targets;
    for (const plan::ObjectUse& each : plan.accesses[node].uses) {
        if (!each.writes) continue;
        if (const auto* texture = std::get_if<scene::TextureView>(&each.object))
            targets.push_back({FrameTarget::Kind::texture, 0, nameOfTexture(scene, *texture), *texture});
        else if (const auto& buffer = std::get<scene::BufferView>(each.object); buffer.buffer)
            targets.push_back(
                {FrameTarget::Kind::buffer, 0, scene.buffers[buffer.buffer].name, {}, buffer.buffer});
    }
    return targets;
}

/// Makes keys that differ.
class ItemKeys {
  public:
    std::string of(const char* kind, int line) {
        return fmt::format("{} {}:{}", kind, line, counted_[{kind, line}]++);
    }
    static std::string of(const char* kind, const DrawId& id) {
        return fmt::format("{} {}:{}:{}", kind, id.file, id.line, id.counter);
    }

  private:
    std::map<std::pair<std::string, int>, int> counted_;
};

/// Numbers the draws of a pass that have the same word and line.
void numberDraws(std::span<FrameItem> ofPass) {
    std::map<std::pair<std::string, int>, std::vector<FrameItem*>> equal;
    for (FrameItem& each : ofPass)
        if (each.kind == FrameItem::Kind::draw) equal[{each.title, each.place.line}].push_back(&each);
    for (const auto& [key, all] : equal)
        for (std::size_t i = 0; i < all.size() && all.size() > 1; ++i)
            all[i]->number = static_cast<int>(i) + 1;
}

std::string programName(const scene::Scene& scene, scene::ProgramIndex program) {
    return program ? scene.programs[program].name : "";
}

}  // namespace

std::vector<FrameItem> frameItems(const scene::Scene& scene, const plan::FramePlan& plan) {
    using Kind = FrameItem::Kind;
    std::vector<FrameItem> items;
    ItemKeys keys;
    const auto add = [&](Kind kind, std::size_t node, scene::StepIndex step, const Place& place,
                         std::string title, std::string program, std::vector<FrameTarget> targets,
                         std::string key) {
        items.push_back({kind, node, step, place, std::move(title), std::move(program), std::move(targets),
                         std::move(key)});
    };
    for (std::size_t node = 0; node < plan.order.size(); ++node) {
        const scene::NodeIndex& at = plan.order[node];
        const render::NodeName name = render::nameOf(scene, plan, node);
        if (at.kind == scene::NodeIndex::Kind::dispatch) {
            const scene::Dispatch& dispatch = plan.dispatchOf(plan.dispatches[at.index]);
            add(Kind::dispatch, node, {}, dispatch.place, name.what, programName(scene, dispatch.program),
                writtenBy(scene, plan, node), ItemKeys::of("dispatch", dispatch.id));
            continue;
        }
        if (at.kind == scene::NodeIndex::Kind::clear) {
            const Place& place = plan.clearOf(plan.clears[at.index]).place;
            add(Kind::clearObject, node, {}, place, name.what, "", writtenBy(scene, plan, node),
                keys.of("object", place.line));
            continue;
        }
        const plan::PlannedPass& planned = plan.passes[at.index];
        const scene::Pass& pass = plan.passOf(planned);
        const std::vector<FrameTarget> targets = targetsOf(scene, pass);
        add(Kind::pass, node, {planned.pass, 0}, pass.place, name.what, "", targets,
            keys.of("pass", pass.place.line));
        const std::size_t first = items.size();
        for (const auto& step : planned.steps) {
            if (const auto* drawn = std::get_if<plan::PlannedDraw>(&step)) {
                const scene::Draw& draw = plan.drawOf(*drawn);
                add(Kind::draw, node, drawn->step, draw.place, draw.word, programName(scene, draw.program),
                    targets, ItemKeys::of("draw", draw.id));
                continue;
            }
            const auto& cleared = std::get<plan::PlannedClear>(step);
            const Place& place = plan.clearOf(cleared).place;
            add(Kind::clear, node, cleared.step, place, "Clear", "", targets, keys.of("clear", place.line));
        }
        numberDraws(std::span(items).subspan(first));
    }
    return items;
}

bool haveSameTargets(const scene::Pass& a, const scene::Pass& b) {
    if (a.isWindow || b.isWindow) return a.isWindow == b.isWindow;
    return a.targets == b.targets && a.parts == b.parts && a.depth == b.depth;
}

}  // namespace glibra::view
