#include "render/scene_renderer.h"

#include <fmt/format.h>

#include <limits>
#include <map>
#include <utility>

#include "gpu/object/readback.h"
#include "plan/buffers.h"
#include "render/consequences.h"
#include "render/load/device_buffers.h"
#include "render/probe/choices.h"

namespace glibra::render {
namespace {

/// Interprets a scene that changes with time for its first picture, so that choices are made for that.
Diagnostics goToFirst(Conductor& conductor, Stats& stats) {
    Diagnostics diagnostics;
    scene::FrameInputs first = conductor.inputs;
    first.time = conductor.options.time;
    if (conductor.changesWithTime && conductor.interpret(first, diagnostics, stats))
        conductor.lookFrom(conductor.options.viewState);
    return diagnostics;
}

}  // namespace

FrameDrawer& SceneRenderer::drawer() {
    state_->conductor.forgetDrawn();  // whoever asks for it will draw
    return *state_->conductor.drawer;
}
void SceneRenderer::setShift(const glm::dvec2& window, std::vector<glm::dvec2> textures) {
    state_->conductor.forgetDrawn();
    state_->conductor.drawer->setShift(window, std::move(textures));
}
void SceneRenderer::measureGpu(GpuTimes& times) {
    state_->gpuTimes = &times;
    Conductor& conductor = state_->conductor;
    if (conductor.drawer) times.watch(*conductor.drawer, conductor.scene, conductor.plan);
    if (conductor.simulation) times.watch(*conductor.simulation, conductor.scene);
}
std::optional<Moment> SceneRenderer::momentOf(double time) const {
    if (remembersFrames()) return std::nullopt;
    std::map<double, double> timers;  // by period
    const Conductor& conductor = state_->conductor;
    const plan::FramePlan& plan = conductor.plan;
    plan.visitStatements([&](const auto& planned, const auto& statement) {
        const double period = statement.timerPeriod;
        const plan::PlannedProgram& program = plan.programs[planned.program];
        for (const plan::UniformBinding& each : program.values) {
            const auto* supplied = std::get_if<plan::Supplied>(&each.value);
            if (!supplied || supplied->value != glsl::Builtin::timer) continue;
            const bool isFloat =
                at(program.interface->uniforms, each.uniform).type.base == plan::BaseType::floating;
            const double timer = timerAt(time, period);
            if (isFloat)
                timers.try_emplace(period, static_cast<float>(timer));
            else
                timers[period] = timer;
        }
    });
    Moment moment;
    for (const auto& [period, timer] : timers) moment.push_back(timer);
    if (conductor.simulation)
        for (const std::int64_t steps : conductor.simulation->stepsAt(time))
            moment.push_back(static_cast<double>(steps));
    if (conductor.changesWithTime) moment.push_back(time);
    return moment;
}

PreparedScene SceneRenderer::begin(gpu::Context& context, const std::filesystem::path& path,
                                   const RenderOptions& options, Stats& stats, SharedParts* shared) {
    PreparedScene begun;
    Result<InterpretedScene> interpreted = interpretFile(path, options, stats);
    begun.isStrict_ = options.strict;
    begun.diagnostics_ = std::move(interpreted.diagnostics);
    applyStrict(begun.diagnostics_, options.strict);
    const bool isWrong = hasError(begun.diagnostics_);
    if (interpreted && (!isWrong || options.incomplete))
        begun.state_ = SceneState::of(context, std::move(*interpreted), options, stats, shared);
    if (begun.state_ && isWrong) (*begun.state_)->conductor.condition = Condition::incomplete;
    return begun;
}

Result<SceneRenderer> SceneRenderer::load(gpu::Context& context, const std::filesystem::path& path,
                                          const RenderOptions& options, Stats& stats, SharedParts* shared) {
    return load(begin(context, path, options, stats, shared), stats);
}

PreparedScene SceneRenderer::prepare(gpu::Context& context, const std::filesystem::path& path,
                                     const RenderOptions& options, Stats& stats, SharedParts* shared) {
    PreparedScene prepared = begin(context, path, options, stats, shared);
    if (prepared.state_) (*prepared.state_)->makeAhead();
    return prepared;
}

Result<SceneRenderer> SceneRenderer::load(PreparedScene prepared, Stats& stats) {
    Diagnostics diagnostics = std::move(prepared.diagnostics_);
    if (!prepared.state_ && prepared.state_.diagnostics.empty()) return diagnostics;
    Result<SceneRenderer> renderer = finish(std::move(prepared.state_), stats);
    append(diagnostics, std::move(renderer.diagnostics));
    applyStrict(diagnostics, prepared.isStrict_);
    renderer.diagnostics = std::move(diagnostics);
    return renderer;
}

Result<SceneRenderer> SceneRenderer::of(gpu::Context& context, InterpretedScene interpreted,
                                        const RenderOptions& options, Stats& stats, SharedParts* shared) {
    return finish(SceneState::of(context, std::move(interpreted), options, stats, shared), stats);
}

Result<SceneRenderer> SceneRenderer::finish(Result<std::unique_ptr<SceneState>> prepared, Stats& stats) {
    Diagnostics diagnostics = std::move(prepared.diagnostics);
    if (!prepared) return diagnostics;
    std::unique_ptr<SceneState> state = std::move(*prepared);
    const bool isBounded = state->conductor.options.maxError > 0;
    if (isBounded && hasBounds(state->conductor.scene)) {
        Result<std::unique_ptr<SceneState>> chosen = chooseValues(*state, stats);
        append(diagnostics, std::move(chosen.diagnostics));
        if (!chosen) return diagnostics;
        state = std::move(*chosen);
    }
    if (isBounded) {
        append(diagnostics, goToFirst(state->conductor, stats));
        state->areSamplesChosen = state->conductor.options.samples == 0;
        state->choose = chooseCounts;
    }
    append(diagnostics, state->conductor.prepare(state->request()));
    if (!state->makeReady(diagnostics)) return diagnostics;
    return {SceneRenderer(std::move(state)), std::move(diagnostics)};
}

void SceneRenderer::drawAhead(double time, Stats& stats) {
    SceneState& state = *state_;
    const Conductor& conductor = state.conductor;
    SceneState::Ahead& ahead = state.ahead.emplace_back();
    Diagnostics& diagnostics = ahead.diagnostics;
    if (!state.stream) state.stream.emplace(conductor.context.capabilities());
    append(diagnostics, state.moveTo(time, stats));
    if (!conductor.stopsWith(diagnostics)) {
        state.drawTile(0, diagnostics, stats);
        Diagnostics unread = state.stream->begin(state.window->readable(), 0,
                                                 {0, 0, state.width, state.height}, state.pixelLayout());
        ahead.isRead = unread.empty();
        append(diagnostics, std::move(unread));
    }
    state.endFrame(diagnostics, stats);
    ahead.condition = conductor.stopsWith(diagnostics) ? Condition::stopped : conductor.condition;
    if (ahead.condition != Condition::stopped) ahead.finish = state.finish();
}

Result<image::Image> SceneRenderer::takeDrawn(Stats& stats) {
    SceneState& state = *state_;
    SceneState::Ahead ahead = std::move(state.ahead.front());
    state.ahead.pop_front();
    image::Image picture = state.emptyPicture();
    if (ahead.isRead) {
        const StageTimer timer(stats, "readback");
        Diagnostics unread = state.stream->take(picture.data);
        state.conductor.note(unread);
        if (state.conductor.stopsWith(unread)) ahead.condition = Condition::stopped;
        if (hasError(unread) && ahead.condition == Condition::whole) ahead.condition = Condition::incomplete;
        append(ahead.diagnostics, std::move(unread));
    }
    if (ahead.condition == Condition::stopped) return std::move(ahead.diagnostics);
    ahead.finish.isIncomplete = ahead.condition == Condition::incomplete;
    return {ahead.finish.finished(std::move(picture)), std::move(ahead.diagnostics)};
}

Result<image::Image> SceneRenderer::drawFirst(std::size_t draws, std::size_t pass, int color, double time,
                                              Stats& stats) {
    Conductor& conductor = state_->conductor;
    conductor.drawer->setDrawLimit(draws);
    Result<image::Image> window = draw(time, stats);
    conductor.drawer->setDrawLimit(std::numeric_limits<std::size_t>::max());
    const scene::Pass& drawn = conductor.plan.passOf(conductor.plan.passes[pass]);
    if (!window || drawn.isWindow) return window;
    const Result<const gpu::Target*> target = conductor.device.target(drawn);
    if (!target) return target.diagnostics;
    image::Image content{(*target)->width(), (*target)->height(), 4, image::Component::f32, {}};
    auto pixels = gpu::readPixels(conductor.context.capabilities(), (*target)->readable(), color,
                                  {0, 0, content.width, content.height}, {4, gpu::TexelType::f32});
    if (!pixels) return std::move(pixels.diagnostics);
    content.data = std::move(*pixels);
    return {std::move(content), std::move(window.diagnostics)};
}

Result<BufferContent> SceneRenderer::bufferContent(const scene::BufferView& view) {
    const DeviceBuffers& buffers = state_->conductor.device.buffers();
    const gpu::Buffer* buffer = buffers.buffer(view);
    const plan::BufferLayout* layout = buffers.layout(view.buffer);
    if (buffer == nullptr || layout == nullptr) {
        const scene::Buffer& declared = state_->conductor.scene.buffers[view.buffer];
        return diagnose("memory-E16",
                        fmt::format("buffer '{}' is not used, so it has no content to save", declared.name),
                        declared.place);
    }
    return contentOf(*layout, *buffer);
}

}  // namespace glibra::render
