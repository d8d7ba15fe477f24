#include "render/scene_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "budget/budget.h"
#include "gpu/object/readback.h"
#include "plan/buffers.h"
#include "render/consequences.h"
#include "render/load/device_buffers.h"
#include "render/probe/bound_probe.h"
#include "render/probe/patch_probe.h"
#include "render/probe/picture_probe.h"
#include "render/probe/probe_options.h"

namespace glibra::render {
namespace {

/// Chooses the values of what the scene declares with Bound. Its state is then made anew.
Result<std::unique_ptr<SceneState>> chooseValues(std::unique_ptr<SceneState> state, Stats& stats) {
    const StageTimer timer(stats, "budget");
    InterpretedScene interpreted{std::move(state->scene), state->source, state->inputs};
    RenderOptions options = state->options;
    budget::ChosenBounds chosen =
        chooseBounds(state->context, interpreted, options, state->width, state->height);
    stats.decisions.insert(stats.decisions.end(), chosen.decisions.begin(), chosen.decisions.end());
    Result<std::unique_ptr<SceneState>> made = SceneState::of(
        state->context, std::move(interpreted), options, stats, state->ownParts ? nullptr : state->parts);
    if (made) (*made)->isIncomplete = state->isIncomplete;
    made.diagnostics.insert(made.diagnostics.begin(), chosen.diagnostics.begin(), chosen.diagnostics.end());
    return made;
}

/// Chooses counts for what a first plan of the scene needs, as it is at the moment of `state`. It is then
/// planned again with the chosen shapes.
Diagnostics chooseCounts(SceneState& state, plan::PlanOptions& planOptions, Stats& stats) {
    scene::Scene& scene = state.scene;
    RenderOptions& options = state.options;
    const plan::FramePlan first = state.planList(scene.frame, planOptions);
    if (hasError(first.diagnostics)) return {};
    const StageTimer timer(stats, "budget");
    const gpu::Capabilities& driver = state.context.capabilities();
    const std::vector<double> moments =
        state.changesWithTime ? std::vector{state.inputs.time} : momentsOf(options);
    const PictureProbe pictures{state, moments};
    PatchProbe probe(state, moments);
    budget::Choice choice = budget::choose(
        scene, first,
        {.maxError = options.maxError,
         .overrideCounts = options.overrideCounts,
         .width = state.width,
         .height = state.height,
         .areSamplesFree = state.areSamplesChosen,
         .mostSamples = driver.maxSamples,
         .clipFromModel =
             [&](const scene::Draw& draw, double aspect) {
                 return state.view.projection(*draw.projection, aspect) * state.view.modelView(draw);
             },
         .contourShift = [&](const budget::Choice& from,
                             const budget::Choice& to) { return pictures.shift(from, to); },
         .mostLevel = driver.maxTessellationLevel,
         .overrides = planOptions.overrides,
         .patches = [&](std::size_t pass, std::size_t step,
                        const budget::Levels& levels) { return probe.patches(pass, step, levels); }});
    if (state.areSamplesChosen) options.samples = choice.samples;
    for (const scene::ShapeIndex shape : budget::apply(choice, scene)) state.device.meshes().forget(shape);
    planOptions.overrides.insert(planOptions.overrides.end(), choice.levels.begin(), choice.levels.end());
    if (state.isMoving) return std::move(choice.diagnostics);  // decisions are those of the first picture
    stats.decisions.insert(stats.decisions.end(), choice.decisions.begin(), choice.decisions.end());
    if (state.changesWithTime && options.lastTime > options.time)
        stats.decisions.push_back(
            {"scene",
             "it changes with time: each picture has its own choice; that of the first:",
             {scene.path, 1, 1}});
    std::ranges::stable_sort(stats.decisions, {}, [](const budget::Decision& each) {
        return std::pair(each.place.line, each.what != "scene");
    });
    return std::move(choice.diagnostics);
}

/// Interprets a scene that changes with time for its first picture, so that choices are made for that.
Diagnostics goToFirst(SceneState& state, Stats& stats) {
    Diagnostics diagnostics;
    scene::FrameInputs first = state.inputs;
    first.time = state.options.time;
    if (state.changesWithTime && state.interpret(first, diagnostics, stats))
        state.lookFrom(state.options.viewState);
    return diagnostics;
}

}  // namespace

FrameDrawer& SceneRenderer::drawer() {
    state_->forgetDrawn();  // whoever asks for it will draw
    return *state_->drawer;
}
void SceneRenderer::setShift(const glm::dvec2& window, std::vector<glm::dvec2> textures) {
    state_->forgetDrawn();
    state_->drawer->setShift(window, std::move(textures));
}
void SceneRenderer::measureGpu(GpuTimes& times) {
    state_->gpuTimes = &times;
    if (state_->drawer) times.watch(*state_->drawer, state_->scene, state_->plan);
    if (state_->simulation) times.watch(*state_->simulation, state_->scene);
}
std::optional<Moment> SceneRenderer::momentOf(double time) const {
    if (remembersFrames()) return std::nullopt;
    std::map<double, double> timers;  // by period
    const plan::FramePlan& plan = state_->plan;
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
    if (state_->simulation)
        for (const std::int64_t steps : state_->simulation->stepsAt(time))
            moment.push_back(static_cast<double>(steps));
    if (state_->changesWithTime) moment.push_back(time);
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
    if (begun.state_) (*begun.state_)->isIncomplete = isWrong;
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
    if (state->options.maxError > 0 && hasBounds(state->scene)) {
        Result<std::unique_ptr<SceneState>> chosen = chooseValues(std::move(state), stats);
        append(diagnostics, std::move(chosen.diagnostics));
        if (!chosen) return diagnostics;
        state = std::move(*chosen);
    }
    const bool isBounded = state->options.maxError > 0;
    if (isBounded) append(diagnostics, goToFirst(*state, stats));
    Result<plan::PlanOptions> planOptions = state->planOptions(false);
    if (planOptions && isBounded) {
        state->areSamplesChosen = state->options.samples == 0;
        append(planOptions.diagnostics, chooseCounts(*state, *planOptions, stats));
        state->choose = chooseCounts;
    }
    append(diagnostics, state->preparePlan(std::move(planOptions), stats));
    if (!state->makeReady(diagnostics, stats)) return diagnostics;
    return {SceneRenderer(std::move(state)), std::move(diagnostics)};
}

void SceneRenderer::drawAhead(double time, Stats& stats) {
    SceneState& state = *state_;
    SceneState::Ahead& ahead = state.ahead.emplace_back();
    Diagnostics& diagnostics = ahead.diagnostics;
    if (!state.stream) state.stream.emplace(state.context.capabilities());
    append(diagnostics, state.moveTo(time, stats));
    const plan::StillNodes still =
        hasError(diagnostics) ? plan::StillNodes() : state.stillNodes(state.width, state.height);
    if (!state.isStopped(diagnostics)) {
        append(diagnostics, state.drawTile(0, time, still, stats));
        Diagnostics unread = state.stream->begin(state.window->readable(), 0,
                                                 {0, 0, state.width, state.height}, state.pixelLayout());
        ahead.isRead = unread.empty();
        append(diagnostics, std::move(unread));
    }
    state.endFrame(diagnostics, stats);
    ahead.isStopped = state.isStopped(diagnostics);
    ahead.isIncomplete = state.isIncomplete;
    if (!ahead.isStopped) ahead.labels = state.labels();
}

Result<image::Image> SceneRenderer::takeDrawn(Stats& stats) {
    SceneState& state = *state_;
    SceneState::Ahead ahead = std::move(state.ahead.front());
    state.ahead.pop_front();
    image::Image picture = state.emptyPicture();
    if (ahead.isRead) {
        const StageTimer timer(stats, "readback");
        Diagnostics unread = state.stream->take(picture.data);
        ahead.isIncomplete = ahead.isIncomplete || hasError(unread);
        ahead.isStopped = state.isStopped(unread) || ahead.isStopped;
        append(ahead.diagnostics, std::move(unread));
    }
    if (ahead.isStopped) return std::move(ahead.diagnostics);
    SceneState::finishPicture(picture, ahead.labels, ahead.isIncomplete);
    return {std::move(picture), std::move(ahead.diagnostics)};
}

Result<image::Image> SceneRenderer::drawFirst(std::size_t draws, std::size_t pass, int color, double time,
                                              Stats& stats) {
    SceneState& state = *state_;
    state.drawer->setDrawLimit(draws);
    Result<image::Image> window = draw(time, stats);
    state.drawer->setDrawLimit(std::numeric_limits<std::size_t>::max());
    const scene::Pass& drawn = state.plan.passOf(state.plan.passes[pass]);
    if (!window || drawn.isWindow) return window;
    const Result<const gpu::Target*> target = state.device.target(drawn);
    if (!target) return target.diagnostics;
    image::Image content{(*target)->width(), (*target)->height(), 4, image::Component::f32, {}};
    auto pixels = gpu::readPixels(state.context.capabilities(), (*target)->readable(), color,
                                  {0, 0, content.width, content.height}, {4, gpu::TexelType::f32});
    if (!pixels) return std::move(pixels.diagnostics);
    content.data = std::move(*pixels);
    return {std::move(content), std::move(window.diagnostics)};
}

Result<BufferContent> SceneRenderer::bufferContent(const scene::BufferView& view) {
    const DeviceBuffers& buffers = state_->device.buffers();
    const gpu::Buffer* buffer = buffers.buffer(view);
    const plan::BufferLayout* layout = buffers.layout(view.buffer);
    if (buffer == nullptr || layout == nullptr) {
        const scene::Buffer& declared = state_->scene.buffers[view.buffer];
        return diagnose("memory-E16",
                        fmt::format("buffer '{}' is not used, so it has no content to save", declared.name),
                        declared.place);
    }
    std::optional<base::StorageBlock> block;
    for (const plan::FramePlan* each : state_->plans())
        if (!block) block = plan::blockOf(*each, view.buffer);
    return contentOf(*layout, block ? &*block : nullptr, *buffer);
}

}  // namespace glibra::render
