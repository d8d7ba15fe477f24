#include "render/draw/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gpu/object/framebuffer.h"
#include "plan/accesses.h"

namespace glibra::render {
namespace {

/// The colour, or the one that the viewer has chosen for the window.
std::array<double, 4> clearColor(const glm::dvec4& color, const PassInProgress& pass) {
    const auto& chosen = pass.frame.view.state().background;
    if (pass.pass.isWindow && chosen) return {(*chosen)[0], (*chosen)[1], (*chosen)[2], (*chosen)[3]};
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
      raster_(context.capabilities()),
      widener_(context.capabilities(), bindings_) {}

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

bool FrameDrawer::isStill(std::size_t node, const Frame& frame) {
    if (frame.still == nullptr || frame.still->nodes.empty() || !frame.still->nodes[node]) return false;
    const bool isPass = plan_.order[node].kind == scene::NodeIndex::Kind::pass;
    stats_.add(isPass ? kStillPasses : kStillDispatches, 1);
    return true;
}

void FrameDrawer::noteNodes() {
    if (memory_) return;
    memory_.emplace();
    bool isStored = false;
    for (std::size_t i = 0; i < plan_.order.size(); ++i) {
        NodeMemory& memory = memory_->emplace_back(memoryOf(plan_, i));
        isStored = isStored || !memory.stored.empty();
        for (const plan::PlannedExchange& each : plan_.accesses[i].exchanges)
            if (each.isFilled || keepsContent(i, each)) memory.ways |= kWaysOfCopies;
    }
    if (!isStored) memory_->clear();
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
    if (!memory_->empty()) order_.before((*memory_)[node]);
    Diagnostics diagnostics = exchangeCopies(node);
    for (const plan::Object& each : plan_.accesses[node].written)
        append(diagnostics, device_.noteWritten(each, bindings_));
    return diagnostics;
}

void FrameDrawer::endNode(std::size_t node) {
    if (!memory_->empty())
        order_.after((*memory_)[node], plan_.order[node].kind == scene::NodeIndex::Kind::pass);
    if (!nodeHook_) return;
    order_.finish();  // the hook may look at everything
    nodeHook_(node, false);
}

std::size_t FrameDrawer::placeInScene(const scene::NodeIndex& node) {
    if (places_.empty())
        for (const scene::NodeIndex& each : plan_.nodes->order) places_.emplace(each, places_.size());
    return places_.at(plan_.declared(node));
}

std::size_t FrameDrawer::afterRounds(std::size_t node, std::size_t& looked, const Frame& frame) {
    const std::vector<scene::Until>& untils = plan_.nodes->untils;
    std::size_t begin = 0;
    while (looked < untils.size() && untils[looked].node <= node) {
        const scene::Until& until = untils[looked++];
        if (until.node < begin) continue;  // of rounds that were left out
        close();                           // the condition sees what has been stored
        const bool holds = frame.holds(until);
        forgetState();
        isOpen_ = true;
        if (!holds) continue;
        begin = until.end;
        while (looked < untils.size() && untils[looked].first >= until.first &&
               untils[looked].end <= until.end)
            ++looked;
        if (begin > node) break;
    }
    return begin;
}

Diagnostics FrameDrawer::drawNodes(const gpu::Target* window, const Frame& frame) {
    Diagnostics diagnostics;
    const bool hasRounds = frame.holds && !plan_.nodes->untils.empty();
    std::size_t looked = 0;   // at NodeList::untils
    std::size_t leftOut = 0;  // the nodes of the scene before this one
    std::size_t draws = 0;    // in the passes before the next one
    std::size_t texturePass = 0;
    for (std::size_t index = 0; index < plan_.order.size() && !hasError(diagnostics); ++index) {
        const scene::NodeIndex& node = plan_.order[index];
        if (hasRounds) {
            const std::size_t place = placeInScene(node);
            leftOut = std::max(leftOut, place < leftOut ? 0 : afterRounds(place, looked, frame));
            if (place < leftOut) continue;
        }
        if (node.kind != scene::NodeIndex::Kind::pass) {
            if (!frame.texturePasses || isStill(index, frame)) continue;
            append(diagnostics, beginNode(index));
            if (node.kind == scene::NodeIndex::Kind::dispatch)
                append(diagnostics, dispatch(plan_.dispatches[node.index], frame));
            else
                clearObject(plan_.clearOf(plan_.clears[node.index]));
            endNode(index);
            continue;
        }
        const plan::PlannedPass& pass = plan_.passes[node.index];
        const std::size_t begin = draws;
        draws += static_cast<std::size_t>(std::ranges::count_if(
            pass.steps, [](const auto& step) { return std::holds_alternative<plan::PlannedDraw>(step); }));
        const scene::Pass& declared = plan_.passOf(pass);
        const bool isWindow = declared.isWindow;
        if (isWindow ? window == nullptr : !frame.texturePasses) continue;
        if (isStill(index, frame)) {
            ++texturePass;
            continue;
        }
        append(diagnostics, beginNode(index));
        ViewMatrices own;
        const ViewMatrices& view = viewOf(declared, frame, own);
        if (isWindow) {
            append(diagnostics,
                   drawPass(pass,
                            {frame, declared, *window, view, frame.tile, frame.width, frame.height, shift_},
                            begin));
        } else {
            Result<const gpu::Target*> made = device_.target(declared);
            append(diagnostics, std::move(made.diagnostics));
            if (!made) {
                endNode(index);
                return diagnostics;
            }
            const gpu::Target& target = **made;
            if (seenTargets_.insert(&target).second) bindings_.forgetWorkUnit();  // it may have been made now
            const glm::dvec2 shift =
                texturePass < textureShifts_.size() ? textureShifts_[texturePass] : glm::dvec2(0);
            ++texturePass;
            const int width = target.width(), height = target.height();
            append(
                diagnostics,
                drawPass(pass, {frame, declared, target, view, {0, 0, width, height}, width, height, shift},
                         begin));
        }
        endNode(index);
    }
    if (hasRounds && !hasError(diagnostics)) afterRounds(plan_.nodes->order.size(), looked, frame);
    return diagnostics;
}

const ViewMatrices& FrameDrawer::viewOf(const scene::Pass& pass, const Frame& frame, ViewMatrices& own) {
    if (!movedCameras_) movedCameras_ = movedCameras(*plan_.nodes);
    if (!movedCameras_->contains(pass.rootCamera)) return own = frame.view.unmoved();
    if (pass.shift != glm::dmat4(1)) return own = frame.view.shifted(pass.shift);
    return frame.view;
}

Diagnostics FrameDrawer::drawPass(const plan::PlannedPass& planned, const PassInProgress& pass,
                                  std::size_t begin) {
    Diagnostics diagnostics;
    for (const auto& step : planned.steps)
        if (const auto* draw = std::get_if<plan::PlannedDraw>(&step)) completeReads(draw->textures);
    beginPass(pass);
    std::size_t drawIndex = begin;
    for (const auto& step : planned.steps) {
        if (drawIndex >= drawLimit_) break;
        if (const auto* draw = std::get_if<plan::PlannedDraw>(&step)) {
            append(diagnostics, drawOne(*draw, pass));
            ++drawIndex;
        } else {
            clear(pass, plan_.clearOf(std::get<plan::PlannedClear>(step)));
        }
    }
    gpu::settleClears(context_.capabilities());  // the draws may have been skipped
    for (const scene::TextureIndex each : pass.pass.targets) device_.textures().wasWritten(each);
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

void FrameDrawer::beginPass(const PassInProgress& pass) {
    const scene::Pass& begun = pass.pass;
    context_.debugLog().setPlace(begun.place);
    pass.target.bind();
    encodeSrgb(pass.target.hasSrgb());
    raster_.targetBound(pass.target.width(), pass.target.height());
    raster_.openForClears();
    for (std::size_t i = 0; i < begun.clearColors.size(); ++i)
        if (const auto& color = begun.clearColors[i])
            pass.target.clearColorOfAnyFormat(static_cast<int>(i), clearColor(*color, pass));
    if (begun.clearDepth)
        pass.target.clearDepth(
            static_cast<float>(begun.isReversed ? 1 - begun.depthValue : begun.depthValue));
    if (begun.clearStencil) pass.target.clearStencil(*begun.clearStencil);
}

void FrameDrawer::clear(const PassInProgress& pass, const scene::Clear& clear) {
    raster_.openForClears();
    const int colors = clear.color ? pass.target.readable().colorCount() : 0;
    for (int i = 0; i < colors; ++i) pass.target.clearColorOfAnyFormat(i, clearColor(*clear.color, pass));
    if (clear.depth) pass.target.clearDepth(pass.pass.isReversed ? 0 : 1);
    if (clear.stencil) pass.target.clearStencil();
}

}  // namespace glibra::render
