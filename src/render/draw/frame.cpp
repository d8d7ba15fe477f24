#include "render/draw/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <utility>

#include "gpu/object/deferred_clears.h"
#include "plan/accesses.h"
#include "render/draw/work_share.h"

namespace glibra::render {
namespace {

std::array<double, 4> asArray(const glm::dvec4& color) {
    return {color.r, color.g, color.b, color.a};
}

}  // namespace

double timerAt(double time, double period) {
    // fmod is exact for any time. The largest float below 1 keeps the quotient from rounding up to 1.
    const double rest = std::fmod(time, period);
    return std::min((rest < 0 ? rest + period : rest) / period, 1 - 0x1p-24);
}

FrameDrawer::FrameDrawer(const gpu::Context& context, const plan::FramePlan& plan,
                         const ProgramLibrary& programs, DeviceScene& device, Stats& stats)
    : context_(context),
      plan_(plan),
      programs_(programs),
      device_(device),
      stats_(stats),
      states_(plan.programs.size()),
      timeShare_(context.capabilities().isSoftware ? 0 : kTimeShare),
      raster_(context.capabilities()) {}

void FrameDrawer::skipOpaqueBlending() {
    blendsOpaque_ = false;
    std::set<const BuiltProgram*> reported;
    plan_.visitDraws([&](const plan::PlannedDraw& draw, const auto&, const scene::Pass& pass) {
        const BuiltProgram* own = pass.isWindow ? ownProgramOf(draw) : nullptr;
        if (own == nullptr || !own->interface.facts.isOpaque || !reported.insert(own).second) return;
        const glsl::TranslatedProgram& facts = own->interface.facts;
        stats_.skip("blending", fmt::format("'{}': always writes 1 for alpha", facts.name), facts.place);
    });
}

bool texturesComeFirst(const plan::FramePlan& plan) {
    const auto isOfWindow = [&](const scene::NodeIndex& node) {
        return node.kind == scene::NodeIndex::Kind::pass && plan.passOf(plan.passes[node.index]).isWindow;
    };
    return std::ranges::is_partitioned(plan.order, std::not_fn(isOfWindow));
}

Diagnostics FrameDrawer::draw(const gpu::Target& window, const Frame& frame) {
    Diagnostics diagnostics;
    const auto begin = [&](const std::vector<scene::ObjectView>& objects) {
        for (const scene::ObjectView& each : objects) {
            const plan::Object object = plan::objectOf(each);
            const bool isKept = frame.still != nullptr && frame.still->contents.contains(object);
            if (!isKept && device_.state(object).isChanged) append(diagnostics, device_.reset(object));
        }
    };
    if (frame.texturePasses) {
        begin(plan_.resets);
        begin(plan_.reads);
    }
    append(diagnostics, execute(&window, frame));
    return diagnostics;
}

Diagnostics FrameDrawer::run(const Frame& frame) {
    return execute(nullptr, frame);
}

Diagnostics FrameDrawer::execute(const gpu::Target* window, const Frame& frame) {
    frame_ = &frame;
    if (!isOpen_) forgetState();
    isOpen_ = true;
    Diagnostics diagnostics = drawNodes(window, frame);
    if (!frame.staysOpen) close();
    return diagnostics;
}

void FrameDrawer::close() {
    if (!std::exchange(isOpen_, false)) return;
    order_.finish();
    if (plan_.passes.empty()) return;  // dispatches do not set raster state
    encodeSrgb(false);
    // Others that draw with this context expect the state in which a pass begins.
    raster_.limitTo({});
    raster_.apply({});
    raster_.limitTo(limit_);
    setTessellationLevels(kOneLevel);
    runPerSample(false);
}

void FrameDrawer::runPerSample(bool on) {
    if (std::exchange(runsPerSample_, on) == on) return;
    glMinSampleShading(1);
    on ? glEnable(GL_SAMPLE_SHADING) : glDisable(GL_SAMPLE_SHADING);
}

void FrameDrawer::encodeSrgb(bool on) {
    if (std::exchange(encodesSrgb_, on) == on) return;
    on ? glEnable(GL_FRAMEBUFFER_SRGB) : glDisable(GL_FRAMEBUFFER_SRGB);
}

void FrameDrawer::forgetState() {
    raster_.forget();
    bindings_.forget();
    clipDistances_.reset();
    patchVertices_.reset();
}

bool FrameDrawer::drawsPlainly() const {
    return !hook_ && !limit_ && !wireframe_ && drawLimit_ == std::numeric_limits<std::size_t>::max() &&
           shift_ == glm::dvec2(0.0) && textureShifts_.empty();
}

bool FrameDrawer::isStill(std::size_t node) {
    if (frame_->still == nullptr || frame_->still->nodes.empty() || !frame_->still->nodes[node]) return false;
    const bool isPass = plan_.order[node].kind == scene::NodeIndex::Kind::pass;
    stats_.add(isPass ? kStillPasses : kStillDispatches, 1);
    return true;
}

void FrameDrawer::noteNodes() {
    if (std::exchange(areNodesNoted_, true)) return;
    bool isStored = false;
    for (std::size_t i = 0; i < plan_.order.size(); ++i) {
        NodeMemory& memory = memory_.emplace_back(memoryOf(plan_, i));
        isStored = isStored || !memory.stored.empty();
        for (const plan::PlannedExchange& each : plan_.accesses[i].exchanges)
            if (each.isFilled || keepsContent(i, each)) memory.ways |= kWaysOfCopies;
    }
    if (!isStored) memory_.clear();
}

Diagnostics FrameDrawer::exchangeCopies(std::size_t node) {
    Diagnostics diagnostics;
    for (const plan::PlannedExchange& each : plan_.accesses[node].exchanges) {
        const bool keeps = keepsContent(node, each);
        if (const auto* buffer = std::get_if<scene::BufferIndex>(&each.object)) {
            device_.buffers().exchange(*buffer, keeps);
            continue;
        }
        const scene::TextureIndex texture = std::get<scene::TextureIndex>(each.object);
        device_.textures().exchange(texture);
        if (keeps) append(diagnostics, device_.textures().copyFromPrevious(texture, bindings_));
    }
    return diagnostics;
}

bool FrameDrawer::keepsContent(std::size_t node, const plan::PlannedExchange& exchange) {
    if (!exchange.keepsContent) return false;
    if (exchange.isFilled) return !drawsPlainly();
    if (!exchange.whole) return true;
    const auto [known, isNew] = covered_.try_emplace(&exchange, false);
    if (isNew) known->second = coversWhole(plan_.dispatches[plan_.order[node].index], exchange);
    return !known->second;
}

Diagnostics FrameDrawer::beginNode(std::size_t node) {
    if (nodeHook_) nodeHook_(node, true);
    noteNodes();
    if (!memory_.empty()) order_.before(memory_[node]);
    Diagnostics diagnostics = exchangeCopies(node);
    for (const plan::Object& each : plan_.accesses[node].written)
        append(diagnostics, device_.noteWritten(each, bindings_));
    return diagnostics;
}

void FrameDrawer::endNode(std::size_t node) {
    if (!memory_.empty()) order_.after(memory_[node], plan_.order[node].kind == scene::NodeIndex::Kind::pass);
    if (!nodeHook_) return;
    order_.finish();  // the hook may look at everything
    nodeHook_(node, false);
}

Diagnostics FrameDrawer::drawNodes(const gpu::Target* window, const Frame& frame) {
    Diagnostics diagnostics;
    std::size_t draws = 0;  // in the passes before the next one
    std::size_t texturePass = 0;
    for (std::size_t index = 0; index < plan_.order.size() && !hasError(diagnostics); ++index) {
        const scene::NodeIndex& node = plan_.order[index];
        if (node.kind != scene::NodeIndex::Kind::pass) {
            if (!frame.texturePasses || isStill(index)) continue;
            append(diagnostics, beginNode(index));
            if (node.kind == scene::NodeIndex::Kind::dispatch)
                append(diagnostics, dispatch(plan_.dispatches[node.index]));
            else
                clearObject(plan_.clearOf(plan_.clears[node.index]));
            endNode(index);
            continue;
        }
        const plan::PlannedPass& pass = plan_.passes[node.index];
        const std::size_t begin = draws;
        draws += static_cast<std::size_t>(std::ranges::count_if(
            pass.steps, [](const auto& step) { return std::holds_alternative<plan::PlannedDraw>(step); }));
        const bool isWindow = plan_.passOf(pass).isWindow;
        if (isWindow ? window == nullptr : !frame.texturePasses) continue;
        if (isStill(index)) {
            ++texturePass;
            continue;
        }
        append(diagnostics, beginNode(index));
        const gpu::Target* target = window;
        if (!isWindow) {
            Result<const gpu::Target*> made = device_.target(plan_.passOf(pass));
            append(diagnostics, std::move(made.diagnostics));
            if (!made) {
                endNode(index);
                return diagnostics;
            }
            target = *made;
            if (seenTargets_.insert(target).second) bindings_.forgetWorkUnit();  // it may have been made now
            texture_ = {0, 0, target->width(), target->height()};
            textureShift_ = texturePass < textureShifts_.size() ? textureShifts_[texturePass] : glm::dvec2(0);
            ++texturePass;
        }
        append(diagnostics, drawPass(pass, *target, begin));
        endNode(index);
    }
    return diagnostics;
}

Diagnostics FrameDrawer::drawPass(const plan::PlannedPass& pass, const gpu::Target& target,
                                  std::size_t begin) {
    Diagnostics diagnostics;
    const scene::Pass& drawn = plan_.passOf(pass);
    for (const auto& step : pass.steps)
        if (const auto* draw = std::get_if<plan::PlannedDraw>(&step)) completeReads(draw->textures);
    beginPass(pass, target);
    std::size_t drawIndex = begin;
    for (const auto& step : pass.steps) {
        if (drawIndex >= drawLimit_) break;
        if (const auto* draw = std::get_if<plan::PlannedDraw>(&step)) {
            append(diagnostics, drawOne(*draw, target, drawn.isWindow));
            ++drawIndex;
        } else {
            clear(target, plan_.clearOf(std::get<plan::PlannedClear>(step)), drawn.isWindow);
        }
    }
    gpu::settleClears(context_.capabilities());  // the draws may have been skipped
    for (const scene::TextureIndex each : drawn.targets) device_.textures().wasWritten(each);
    stats_.add("passes", 1);
    return diagnostics;
}

void FrameDrawer::completeReads(const std::vector<plan::TextureUse>& textures) {
    bool isScissorOff = false;
    for (const plan::TextureUse& use : textures) {
        if (use.isImage || !device_.textures().isIncomplete(use)) continue;
        if (!std::exchange(isScissorOff, true)) {  // it would cut what resolving the samples writes
            raster_.limitTo({});
            raster_.openForClears();
        }
        device_.textures().complete(use);
        bindings_.forgetWorkUnit();
    }
    if (isScissorOff) raster_.limitTo(limit_);
}

void FrameDrawer::beginPass(const plan::PlannedPass& pass, const gpu::Target& target) {
    const scene::Pass& begun = plan_.passOf(pass);
    context_.debugLog().setPlace(begun.place);
    if (!movedCameras_) movedCameras_ = movedCameras(*plan_.nodes);
    isAsWindow_ = movedCameras_->contains(begun.rootCamera);
    if (!isAsWindow_) {
        passView_ = frame_->view.unmoved();
    } else if (begun.shift != glm::dmat4(1)) {
        isAsWindow_ = false;
        passView_ = frame_->view.shifted(begun.shift);
    }
    target.bind();
    encodeSrgb(target.hasSrgb());
    raster_.targetBound(target.width(), target.height());
    raster_.openForClears();
    for (std::size_t i = 0; i < begun.clearColors.size(); ++i)
        if (const auto& color = begun.clearColors[i])
            target.clearColorOfAnyFormat(static_cast<int>(i), asArray(clearColor(*color, begun.isWindow)));
    if (begun.clearDepth) target.clearDepth(static_cast<float>(begun.depthValue));
    if (begun.clearStencil) target.clearStencil(*begun.clearStencil);
}

void FrameDrawer::clear(const gpu::Target& target, const scene::Clear& clear, bool isWindow) {
    raster_.openForClears();
    const int colors = clear.color ? target.readable().colorCount() : 0;
    for (int i = 0; i < colors; ++i)
        target.clearColorOfAnyFormat(i, asArray(clearColor(*clear.color, isWindow)));
    if (clear.depth) target.clearDepth();
    if (clear.stencil) target.clearStencil();
}

glm::dvec4 FrameDrawer::clearColor(const glm::dvec4& color, bool isWindow) const {
    const auto& chosen = frame_->view.state().background;
    if (!isWindow || !chosen) return color;
    return {(*chosen)[0], (*chosen)[1], (*chosen)[2], (*chosen)[3]};
}

}  // namespace glibra::render
