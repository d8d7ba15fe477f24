#include "render/scene_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "gpu/object/readback.h"
#include "plan/accesses.h"
#include "plan/buffer_table.h"
#include "render/draw/tiles.h"
#include "render/file/buffer_file.h"
#include "render/file/incomplete_mark.h"
#include "render/file/labels.h"
#include "render/load/open_loops.h"
#include "render/probe/bound_probe.h"
#include "render/probe/gpu_times.h"
#include "render/scene_state.h"

namespace glibra::render {
namespace {

/// Larger pictures are drawn in tiles, so that the use of device memory is bounded: 8192 x 8192.
constexpr std::int64_t kMostPixelsAtOnce = std::int64_t{1} << 26;
constexpr std::int64_t kMostPixels = std::int64_t{1} << 30;

gpu::PixelLayout layoutOf(const image::Image& picture) {
    return {picture.components,
            picture.type == image::Component::f32 ? gpu::TexelType::f32 : gpu::TexelType::u8};
}

void makePixels(image::Image& picture) {
    picture.data.resize(picture.rowBytes() * static_cast<std::size_t>(picture.height));
}

void finishPicture(image::Image& picture, const std::optional<LabelBlock>& labels, bool isIncomplete) {
    if (labels) drawLabels(picture, *labels, labels->left, labels->top);
    if (isIncomplete) markIncomplete(picture);
}

}  // namespace

SceneRenderer::SceneRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;
SceneRenderer::~SceneRenderer() = default;

PreparedScene::PreparedScene() = default;
PreparedScene::PreparedScene(PreparedScene&&) noexcept = default;
PreparedScene& PreparedScene::operator=(PreparedScene&&) noexcept = default;
PreparedScene::~PreparedScene() = default;

FrameDrawer& SceneRenderer::drawer() {
    state_->forgetDrawn();  // whoever asks for it will draw
    return *state_->drawer;
}
const DeviceScene& SceneRenderer::device() const {
    return state_->device;
}
const scene::Scene& SceneRenderer::scene() const {
    return state_->scene;
}
const plan::FramePlan& SceneRenderer::plan() const {
    return state_->plan;
}
int SceneRenderer::width() const {
    return state_->width;
}
void SceneRenderer::setShift(const glm::dvec2& window, std::vector<glm::dvec2> textures) {
    state_->forgetDrawn();
    state_->drawer->setShift(window, std::move(textures));
}
void SceneRenderer::setView(const ViewMatrices& view) {
    state_->forgetDrawn();
    state_->view = view;
}
void SceneRenderer::measureGpu(GpuTimes& times) {
    state_->gpuTimes = &times;
    if (state_->drawer) times.watch(*state_->drawer, state_->scene, state_->plan);
    if (state_->simulation) times.watch(*state_->simulation, state_->scene);
}
int SceneRenderer::height() const {
    return state_->height;
}

bool SceneRenderer::remembersFrames() const {
    return state_->isStateful;
}

bool SceneRenderer::runsSteps() const {
    return state_->simulation.has_value();
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
        begun.state_ = State::of(context, std::move(*interpreted), options, stats, shared);
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
    return finish(State::of(context, std::move(interpreted), options, stats, shared), stats);
}

Result<std::unique_ptr<SceneRenderer::State>> SceneRenderer::State::of(gpu::Context& context,
                                                                       InterpretedScene interpreted,
                                                                       const RenderOptions& options,
                                                                       Stats& stats, SharedParts* shared) {
    const int width = options.width > 0 ? options.width : interpreted.scene.width;
    const int height = options.height > 0 ? options.height : interpreted.scene.height;
    if (static_cast<std::int64_t>(width) * height > kMostPixels)
        return diagnose(
            "glib-E15",
            fmt::format("a picture of {} x {} pixels is too large; the limit is 2^30 pixels", width, height),
            {interpreted.scene.path, 1, 1});
    const gpu::Capabilities& capabilities = context.capabilities();
    const int largest = std::min(
        {capabilities.maxRenderbufferSide, capabilities.maxViewportWidth, capabilities.maxViewportHeight});
    TileGrid grid = tileGrid(width, height, options.tileSize, largest, kMostPixelsAtOnce);

    auto state = std::make_unique<State>(context, options, std::move(interpreted),
                                         grid.tiles.size() > 1 || options.tileSize > 0, stats,
                                         options.skip ? shared : nullptr);
    state->width = width;
    state->height = height;
    state->tiles = std::move(grid.tiles);
    state->tileParts = std::move(grid.parts);
    Diagnostics diagnostics;
    state->placeEye(static_cast<double>(width) / height, diagnostics, stats);
    state->lookFrom(options.viewState);
    return {std::move(state), std::move(diagnostics)};
}

/// Chooses the values of what the scene declares with Bound. Its state is then made anew.
Result<std::unique_ptr<SceneRenderer::State>> SceneRenderer::chooseValues(std::unique_ptr<State> state,
                                                                          Stats& stats) {
    const StageTimer timer(stats, "budget");
    InterpretedScene interpreted{std::move(state->scene), state->source, state->inputs};
    RenderOptions options = state->options;
    budget::ChosenBounds chosen =
        chooseBounds(state->context, interpreted, options, state->width, state->height);
    stats.decisions.insert(stats.decisions.end(), chosen.decisions.begin(), chosen.decisions.end());
    Result<std::unique_ptr<State>> made = State::of(state->context, std::move(interpreted), options, stats,
                                                    state->ownParts ? nullptr : state->parts);
    if (made) (*made)->isIncomplete = state->isIncomplete;
    made.diagnostics.insert(made.diagnostics.begin(), chosen.diagnostics.begin(), chosen.diagnostics.end());
    return made;
}

Result<SceneRenderer> SceneRenderer::finish(Result<std::unique_ptr<State>> prepared, Stats& stats) {
    Diagnostics diagnostics = std::move(prepared.diagnostics);
    if (!prepared) return diagnostics;
    std::unique_ptr<State> state = std::move(*prepared);
    if (state->options.maxError > 0 && hasBounds(state->scene)) {
        Result<std::unique_ptr<State>> chosen = chooseValues(std::move(state), stats);
        append(diagnostics, std::move(chosen.diagnostics));
        if (!chosen) return diagnostics;
        state = std::move(*chosen);
    }
    const gpu::Context& context = state->context;
    const gpu::Capabilities& capabilities = context.capabilities();
    const RenderOptions& options = state->options;
    const auto refuse = [&](Diagnostics found) {
        applyStrict(found, options.strict);
        return Result<SceneRenderer>(std::move(found));
    };
    append(diagnostics, state->preparePlan(stats, false));
    explainRemovedLoops(state->plan, state->programs, diagnostics);
    applyStrict(diagnostics, options.strict);
    if (state->isStopped(diagnostics)) return refuse(std::move(diagnostics));

    const Diagnostics ofTiles = state->checkTiles();
    append(diagnostics, ofTiles);
    if (hasError(ofTiles)) return refuse(std::move(diagnostics));
    state->makePictureDrawer(stats);
    state->isStateful = state->mayShowEarlierFrames();
    state->device.meshes().release();

    Result<gpu::Target> window =
        gpu::Target::window(capabilities, state->tiles.front().width, state->tiles.front().height,
                            options.floatPixels ? gpu::TexelFormat::rgba32f : gpu::TexelFormat::rgba8,
                            state->options.samples, depthFormat(state->scene));
    append(diagnostics, std::move(window.diagnostics));
    if (!window) return refuse(std::move(diagnostics));
    state->window = std::move(window.value);
    if (options.axes) append(diagnostics, state->makeAxes());
    append(diagnostics, context.debugLog().takeDiagnostics());
    applyStrict(diagnostics, options.strict);
    if (state->isStopped(diagnostics)) return refuse(std::move(diagnostics));
    return {SceneRenderer(std::move(state)), std::move(diagnostics)};
}

/// Every tile would run the effects again.
Diagnostics SceneRenderer::State::checkTiles() const {
    if (!scene.isModern || tiles.size() == 1) return {};
    Diagnostics found;
    plan.visitDraws([&](const plan::PlannedDraw& each, const scene::Draw& draw, const scene::Pass& pass) {
        if (!found.empty() || !pass.isWindow ||
            !plan::writesMemory(plan.programs[each.program], each.textures))
            return;
        found.push_back(diagnose("memory-E10",
                                 fmt::format("{} writes memory, so the window cannot be drawn in {} tiles; "
                                             "choose a smaller size or larger tiles",
                                             draw.word, tiles.size()),
                                 draw.place));
    });
    return found;
}

void SceneRenderer::State::makePictureDrawer(Stats& stats) {
    makeDrawer(stats);
    if (options.skip && tiles.size() > 1) drawer->cullToTile(options.samples);
    if (options.skip && !options.floatPixels) drawer->skipOpaqueBlending();
    if (gpuTimes) gpuTimes->watch(*drawer, scene, plan);
}

Diagnostics SceneRenderer::State::moveTo(double time, Stats& stats) {
    Diagnostics diagnostics;
    bool isOther = false;
    if (changesWithTime && inputs.time != time) {
        scene::FrameInputs wanted = inputs;
        wanted.time = time;
        isOther = interpret(wanted, diagnostics, stats);
    }
    inputs.time = time;
    if (isOther) {
        lookFrom(options.viewState);
        isMoving = true;
        append(diagnostics, preparePlan(stats, false));
        if (isStopped(diagnostics)) return diagnostics;
    }
    if (simulation) append(diagnostics, simulation->advance(inputs));
    if (isOther && !isStopped(diagnostics)) makePictureDrawer(loadStats);
    return diagnostics;
}

void SceneRenderer::State::resolve() {
    const bool isTimed = gpuTimes != nullptr && window->samples() > 1;
    if (isTimed) gpuTimes->beginWork({"means of the window's samples", 0});
    window->resolve();
    if (isTimed) gpuTimes->endWork();
}

Diagnostics SceneRenderer::State::drawTile(std::size_t index, double time, const plan::StillNodes& still,
                                           Stats& stats) {
    const StageTimer timer(stats, "draw");
    const bool textures = index == 0 || !texturesComeFirst(plan);
    Diagnostics diagnostics =
        drawer->draw(*window, {view, width, height, tiles[index], time, textures, &still});
    if (axes) axes->draw(*window, scene, view, tiles[index], width, height);
    resolve();
    return diagnostics;
}

Diagnostics SceneRenderer::State::readTile(std::size_t index, image::Image& picture, Stats& stats) {
    const Tile& tile = tiles[index];
    const Tile& part = tileParts[index];
    const StageTimer timer(stats, "readback");
    const gpu::PixelRectangle rectangle{part.x - tile.x, part.y - tile.y, part.width, part.height};
    if (tiles.size() == 1)
        return gpu::readPixels(context.capabilities(), window->readable(), 0, rectangle, layoutOf(picture),
                               picture.data);
    auto pixels =
        gpu::readPixels(context.capabilities(), window->readable(), 0, rectangle, layoutOf(picture));
    if (pixels) pasteTile(*pixels, part, picture);
    return std::move(pixels.diagnostics);
}

std::optional<LabelBlock> SceneRenderer::State::labels() const {
    if (options.labels == LabelCorner::none) return std::nullopt;
    return labelBlock(width, height, labelsOf(scene, plans()), options.labels);
}

/// Without pixels.
image::Image SceneRenderer::State::emptyPicture() const {
    return {width,
            height,
            options.alpha ? 4 : 3,
            options.floatPixels ? image::Component::f32 : image::Component::u8,
            {}};
}

void SceneRenderer::State::endFrame(Diagnostics& diagnostics, Stats& stats) {
    noteDrawn(width, height, diagnostics);
    stats.add("frames", 1);
    append(diagnostics, context.debugLog().takeDiagnostics());
    if (options.checkUndefined) append(diagnostics, programs.takeUndefined());
    applyStrict(diagnostics, options.strict);
}

Result<image::Image> SceneRenderer::draw(double time, Stats& stats) {
    State& state = *state_;
    image::Image picture = state.emptyPicture();
    makePixels(picture);
    Diagnostics diagnostics = state.moveTo(time, stats);
    const plan::StillNodes still =
        hasError(diagnostics) ? plan::StillNodes() : state.stillNodes(state.width, state.height);
    for (std::size_t i = 0; i < state.tiles.size() && !state.isStopped(diagnostics); ++i) {
        append(diagnostics, state.drawTile(i, time, still, stats));
        append(diagnostics, state.readTile(i, picture, stats));
    }
    state.endFrame(diagnostics, stats);
    if (state.isStopped(diagnostics)) return diagnostics;
    finishPicture(picture, state.labels(), state.isIncomplete);
    return {std::move(picture), std::move(diagnostics)};
}

bool SceneRenderer::gainsFromDrawingAhead() const {
    return state_->tiles.size() == 1 && !state_->context.capabilities().isSoftware;
}

void SceneRenderer::drawAhead(double time, Stats& stats) {
    State& state = *state_;
    State::Ahead& ahead = state.ahead.emplace_back();
    Diagnostics& diagnostics = ahead.diagnostics;
    if (!state.stream) state.stream.emplace(state.context.capabilities());
    append(diagnostics, state.moveTo(time, stats));
    const plan::StillNodes still =
        hasError(diagnostics) ? plan::StillNodes() : state.stillNodes(state.width, state.height);
    if (!state.isStopped(diagnostics)) {
        append(diagnostics, state.drawTile(0, time, still, stats));
        Diagnostics unread = state.stream->begin(
            state.window->readable(), 0, {0, 0, state.width, state.height}, layoutOf(state.emptyPicture()));
        ahead.isRead = unread.empty();
        append(diagnostics, std::move(unread));
    }
    state.endFrame(diagnostics, stats);
    ahead.isStopped = state.isStopped(diagnostics);
    ahead.isIncomplete = state.isIncomplete;
    if (!ahead.isStopped) ahead.labels = state.labels();
}

Result<image::Image> SceneRenderer::takeDrawn(Stats& stats) {
    State& state = *state_;
    State::Ahead ahead = std::move(state.ahead.front());
    state.ahead.pop_front();
    image::Image picture = state.emptyPicture();
    makePixels(picture);
    if (ahead.isRead) {
        const StageTimer timer(stats, "readback");
        Diagnostics unread = state.stream->take(picture.data);
        ahead.isIncomplete = ahead.isIncomplete || hasError(unread);
        ahead.isStopped = state.isStopped(unread) || ahead.isStopped;
        append(ahead.diagnostics, std::move(unread));
    }
    if (ahead.isStopped) return std::move(ahead.diagnostics);
    finishPicture(picture, ahead.labels, ahead.isIncomplete);
    return {std::move(picture), std::move(ahead.diagnostics)};
}

Result<image::Image> SceneRenderer::drawFirst(std::size_t draws, std::size_t pass, int color, double time,
                                              Stats& stats) {
    State& state = *state_;
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

Result<image::Image> SceneRenderer::textureImage(const scene::TextureView& view) {
    return state_->device.textures().imageOf(view);
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
    std::vector<const plan::FramePlan*> plans{&state_->plan};
    if (state_->simulation)
        for (const plan::FramePlan* each : state_->simulation->plans()) plans.push_back(each);
    std::optional<base::StorageBlock> block;
    for (const plan::FramePlan* each : plans)
        if (!block) block = plan::blockOf(*each, view.buffer);
    BufferContent content{*layout, {}, std::vector<std::byte>(buffer->size())};
    content.table =
        plan::tableOf(*layout, block ? &*block : nullptr, std::numeric_limits<std::size_t>::max());
    buffer->read(0, content.bytes);
    return content;
}

}  // namespace glibra::render
