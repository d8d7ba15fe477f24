#include "render/scene_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "budget/budget.h"
#include "gpu/object/readback.h"
#include "plan/buffer_table.h"
#include "render/consequences.h"
#include "render/load/buffer_content.h"
#include "render/probe/bound_probe.h"
#include "render/probe/patch_probe.h"
#include "render/probe/picture_probe.h"

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

/// Chooses counts for what a first plan needs. The scene is then planned again with the chosen shapes.
Diagnostics chooseCounts(SceneState& state, plan::PlanOptions& planOptions, Stats& stats) {
    scene::Scene& scene = state.scene;
    RenderOptions& options = state.options;
    // A picture of another moment would need other counts.
    if (state.changesWithTime) {
        stats.decisions.push_back(
            {"scene", "counts, samples and noise kept: it changes with time", {scene.path, 1, 1}});
        return {};
    }
    const plan::FramePlan first = state.planList(scene.frame, planOptions);
    if (hasError(first.diagnostics)) return {};
    const StageTimer timer(stats, "budget");
    const gpu::Capabilities& driver = state.context.capabilities();
    const ViewMatrices& view = state.view;
    const PictureProbe pictures{state.context, scene, options, state.width, state.height, view, state.parts};
    PatchProbe probe(state.context, scene, options, state.width, state.height);
    budget::Choice choice =
        budget::choose(scene, first,
                       {.maxError = options.maxError,
                        .overrideCounts = options.overrideCounts,
                        .width = state.width,
                        .height = state.height,
                        .areSamplesFree = options.samples == 0,
                        .mostSamples = driver.maxSamples,
                        .clipFromModel =
                            [&](const scene::Draw& draw, double aspect) {
                                return view.projection(draw.projection, aspect) * view.modelView(draw);
                            },
                        .contourShift = [&](const budget::Choice& from,
                                            const budget::Choice& to) { return pictures.shift(from, to); },
                        .mostLevel = driver.maxTessellationLevel,
                        .overrides = planOptions.overrides,
                        .patches = [&](std::size_t pass, std::size_t step,
                                       auto values) { return probe.patches(pass, step, values); }});
    if (options.samples == 0) options.samples = choice.samples;
    for (const scene::ShapeIndex shape : budget::apply(choice, scene)) state.device.meshes().forget(shape);
    planOptions.overrides.insert(planOptions.overrides.end(), choice.levels.begin(), choice.levels.end());
    stats.decisions.insert(stats.decisions.end(), choice.decisions.begin(), choice.decisions.end());
    std::ranges::stable_sort(stats.decisions, {},
                             [](const budget::Decision& each) { return each.place.line; });
    return std::move(choice.diagnostics);
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
    Result<plan::PlanOptions> planOptions = state->planOptions(false);
    if (planOptions && state->options.maxError > 0)
        append(planOptions.diagnostics, chooseCounts(*state, *planOptions, stats));
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
