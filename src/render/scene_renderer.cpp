#include "render/scene_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include "budget/budget.h"
#include "gpu/loop_limit.h"
#include "gpu/readback.h"
#include "render/axes.h"
#include "render/frame.h"
#include "render/sight.h"
#include "render/tiles.h"
#include "scene/primitives.h"
#include "scene/view.h"

namespace glibra::render {
namespace {

/// Larger pictures are drawn in tiles, so that the device's memory stays bounded: 8192 x 8192.
constexpr std::int64_t kMostPixelsAtOnce = std::int64_t{1} << 26;
constexpr std::int64_t kMostPixels = std::int64_t{1} << 30;

}  // namespace

/// Everything that refers to something else here lies on the heap behind one pointer, in the order of
/// dependence.
struct SceneRenderer::State {
    State(gpu::Context& usedContext, RenderOptions usedOptions, scene::Scene interpreted, bool tiled,
          Stats& stats, SharedParts* shared)
        : context(usedContext),
          options(std::move(usedOptions)),
          scene(std::move(interpreted)),
          programs(context, scene, options, tiled, stats, shared),
          device(context, scene, stats, shared) {}

    gpu::Context& context;
    RenderOptions options;
    scene::Scene scene;
    ProgramLibrary programs;
    DeviceScene device;
    plan::FramePlan plan;
    std::optional<FrameDrawer> drawer;
    std::optional<Axes> axes;
    std::vector<Tile> tiles;  ///< with their margins
    std::vector<Tile> parts;  ///< what of each tile goes into the picture
    std::optional<gpu::Target> window;
    int width = 0, height = 0;
    ViewMatrices view;
    bool isStateful = false;  ///< remembersFrames()

    [[nodiscard]] plan::FramePlan planScene(const plan::PlanOptions& planOptions);
    Diagnostics preparePlan(Stats& stats, bool everything);
    Diagnostics keepBudget(const plan::PlanOptions& planOptions, Stats& stats);
    Diagnostics placeEye(Stats& stats);
    std::string outOfSight(const scene::Draw& draw, const scene::Pass& pass, Diagnostics& diagnostics);
    [[nodiscard]] bool mayShowEarlierFrames();
    Diagnostics drawTile(std::size_t index, double time, image::Image& picture, Stats& stats);
};

plan::FramePlan SceneRenderer::State::planScene(const plan::PlanOptions& planOptions) {
    return plan::planFrame(
        scene,
        [this](const plan::ProgramVariant& variant) -> const plan::ProgramInterface& {
            return programs.interfaceOf(variant);
        },
        [this](int program) { return programs.mayWriteImages(program); }, planOptions);
}

/// Counts are chosen for what a plan needs; with the shapes as they are then, it is planned again.
Diagnostics SceneRenderer::State::keepBudget(const plan::PlanOptions& planOptions, Stats& stats) {
    const plan::FramePlan first = planScene(planOptions);
    if (hasError(first.diagnostics)) return {};
    const StageTimer timer(stats, "budget");
    budget::Choice choice =
        budget::choose(scene, first,
                       {.maxError = options.maxError,
                        .overrideCounts = options.overrideCounts,
                        .width = width,
                        .height = height,
                        .areSamplesFree = options.samples == 0,
                        .mostSamples = context.capabilities().maxSamples,
                        .clipFromModel = [&](const scene::Draw& draw, double aspect) {
                            return view.projection(draw.projection, aspect) * view.modelView(draw);
                        }});
    if (options.samples == 0) options.samples = choice.samples;
    for (const int shape : budget::apply(choice, scene)) device.forgetMesh(shape);
    stats.decisions = std::move(choice.decisions);
    return std::move(choice.diagnostics);
}

Diagnostics SceneRenderer::State::preparePlan(Stats& stats, bool everything) {
    Result<std::vector<plan::Override>> overrides = parseOverrides(options.set);
    if (!overrides) return std::move(overrides.diagnostics);
    plan::PlanOptions planOptions;
    planOptions.overrides = std::move(*overrides);
    planOptions.maxTextureUnits = context.capabilities().combinedTextureUnits;
    planOptions.loopLimit = [this] { return gpu::measureLoopLimit(context); };
    planOptions.everything = everything || !options.skip;
    planOptions.shareMeshes = options.skip;
    if (!options.skip) device.separateTextures();
    Diagnostics diagnostics;
    if (options.maxError > 0 && !everything) append(diagnostics, keepBudget(planOptions, stats));
    options.samples = std::max(1, options.samples);
    Diagnostics meshDiagnostics;
    if (!planOptions.everything)
        planOptions.outOfSight = [&](const scene::Draw& draw, const scene::Pass& pass) {
            return outOfSight(draw, pass, meshDiagnostics);
        };
    plan = planScene(planOptions);
    stats.skipped.insert(stats.skipped.begin(), plan.skipped.begin(), plan.skipped.end());
    append(diagnostics, std::move(plan.diagnostics));
    plan.diagnostics.clear();
    append(diagnostics, std::move(meshDiagnostics));
    if (!hasError(diagnostics)) append(diagnostics, device.prepare(plan, programs));
    return diagnostics;
}

std::string SceneRenderer::State::outOfSight(const scene::Draw& draw, const scene::Pass& pass,
                                             Diagnostics& diagnostics) {
    const geometry::Topology topology = scene::topologyOf(scene.shapes[static_cast<std::size_t>(draw.shape)]);
    const plan::ProgramVariant variant = plan::variantOf(scene, draw, pass);
    const glsl::Placement placement = programs.placementOf(variant);
    if (topology == geometry::Topology::patches || placement == glsl::Placement::unknown) return {};
    Screen screen{width, height, {0, 0, width, height}, options.samples, options.tileSize > 0};
    if (!pass.targets.empty()) {
        const scene::Texture& target = scene.textures[static_cast<std::size_t>(pass.targets.front())];
        const auto* size = std::get_if<scene::EmptySource>(&target.source);
        if (!size) return {};
        screen = {size->width, size->height, {0, 0, size->width, size->height}, 1, false};
    }
    const Bounds& bounds = device.bounds(draw.shape, programs.mayReadTangents(variant), diagnostics);
    const Lens lens = lensOf(draw, topology, view, screen, context.capabilities());
    return std::string(describe(sightOf(placed(bounds, placement), lens)));
}

/// A target that is neither cleared nor drawn to before it is drawn to or read shows the frame before.
bool SceneRenderer::State::mayShowEarlierFrames() {
    const bool writesImages =
        std::any_of(plan.programs.begin(), plan.programs.end(), [this](const plan::PlannedProgram& each) {
            return each.variant.program != scene::kNone && programs.mayWriteImages(each.variant.program);
        });
    if (writesImages) return true;
    std::set<int> targets;
    for (const plan::PlannedPass& pass : plan.passes)
        targets.insert(pass.pass->targets.begin(), pass.pass->targets.end());
    std::set<int> fresh;        // targets with content of this frame
    std::set<int> freshDepths;  // depth buffers likewise
    for (const plan::PlannedPass& pass : plan.passes) {
        const auto& steps = pass.steps;
        const bool isCleared = !steps.empty() && std::holds_alternative<const scene::Clear*>(steps.front());
        for (std::size_t i = 0; i < pass.pass->targets.size(); ++i)
            if (isCleared || pass.pass->clearColors[i]) fresh.insert(pass.pass->targets[i]);
        if (isCleared || pass.pass->clearDepth) freshDepths.insert(pass.pass->depthBuffer);
        const auto isOld = [&](int texture) { return targets.contains(texture) && !fresh.contains(texture); };
        if (std::any_of(pass.pass->targets.begin(), pass.pass->targets.end(), isOld) ||
            (!pass.pass->targets.empty() && !freshDepths.contains(pass.pass->depthBuffer)))
            return true;
        for (const auto& step : steps)
            if (const auto* draw = std::get_if<plan::PlannedDraw>(&step))
                for (const plan::TextureUse& use : draw->textures)
                    if (isOld(use.texture)) return true;
    }
    return false;
}

Diagnostics SceneRenderer::State::placeEye(Stats& stats) {
    Diagnostics diagnostics;
    double eyeDistance = 0;
    if (options.view != ViewPolicy::glman && !scene.usesLookAt) {
        const StageTimer timer(stats, "view");
        const scene::ViewMove move = scene::autoView(
            scene, [&](int shape) { return device.mesh(shape, false, diagnostics); },
            static_cast<double>(width) / height);
        eyeDistance = move.distance;
        append(diagnostics, move.diagnostics);
    }
    view = ViewMatrices(options.viewState, scene.view, eyeDistance);
    return diagnostics;
}

SceneRenderer::SceneRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;
SceneRenderer::~SceneRenderer() = default;

const scene::Scene& SceneRenderer::scene() const {
    return state_->scene;
}
const plan::FramePlan& SceneRenderer::plan() const {
    return state_->plan;
}
int SceneRenderer::width() const {
    return state_->width;
}
void SceneRenderer::setShift(double x, double y) {
    state_->drawer->setShift(x, y);
}
int SceneRenderer::height() const {
    return state_->height;
}

bool SceneRenderer::remembersFrames() const {
    return state_->isStateful;
}

std::optional<Moment> SceneRenderer::momentOf(double time) const {
    if (remembersFrames()) return std::nullopt;
    std::map<double, double> timers;  // by period
    for (const plan::PlannedPass& pass : state_->plan.passes)
        for (const auto& step : pass.steps) {
            const auto* draw = std::get_if<plan::PlannedDraw>(&step);
            if (!draw) continue;
            const plan::PlannedProgram& program =
                state_->plan.programs[static_cast<std::size_t>(draw->program)];
            for (const plan::UniformBinding& each : program.values) {
                const auto* supplied = std::get_if<plan::Supplied>(&each.value);
                if (!supplied || supplied->value != glsl::Builtin::timer) continue;
                const bool isFloat =
                    program.interface->uniforms[static_cast<std::size_t>(each.uniform)].type.base ==
                    plan::BaseType::floating;
                const double timer = timerAt(time, draw->draw->timerPeriod);
                timers[draw->draw->timerPeriod] =
                    isFloat ? static_cast<double>(static_cast<float>(timer)) : timer;
            }
        }
    Moment moment;
    for (const auto& [period, timer] : timers) moment.push_back(timer);
    return moment;
}

Result<SceneRenderer> SceneRenderer::load(gpu::Context& context, const std::filesystem::path& path,
                                          const RenderOptions& options, Stats& stats, SharedParts* shared) {
    const auto refuse = [&](Diagnostics diagnostics) {
        applyStrict(diagnostics, options.strict);
        return Result<SceneRenderer>(std::move(diagnostics));
    };
    Result<scene::Scene> interpreted = interpretFile(path, options, stats);
    Diagnostics diagnostics = std::move(interpreted.diagnostics);
    applyStrict(diagnostics, options.strict);
    if (!interpreted || hasError(diagnostics)) return refuse(std::move(diagnostics));

    const int width = options.width > 0 ? options.width : interpreted->width;
    const int height = options.height > 0 ? options.height : interpreted->height;
    if (static_cast<std::int64_t>(width) * height > kMostPixels) {
        diagnostics.push_back(
            error("glib-E15", fmt::format("a picture of {} x {} pixels; the limit is 2^30", width, height),
                  {path.string(), 1, 1}));
        return refuse(std::move(diagnostics));
    }
    const gpu::Capabilities& capabilities = context.capabilities();
    const int largest = std::min(
        {capabilities.maxRenderbufferSide, capabilities.maxViewportWidth, capabilities.maxViewportHeight});
    const TileGrid grid = tileGrid(width, height, options.tileSize, largest, kMostPixelsAtOnce);

    auto state = std::make_unique<State>(context, options, std::move(*interpreted),
                                         grid.tiles.size() > 1 || options.tileSize > 0, stats,
                                         options.skip ? shared : nullptr);
    state->width = width;
    state->height = height;
    state->tiles = grid.tiles;
    state->parts = grid.parts;
    append(diagnostics, state->placeEye(stats));
    append(diagnostics, state->preparePlan(stats, false));
    applyStrict(diagnostics, options.strict);
    if (hasError(diagnostics)) return refuse(std::move(diagnostics));

    state->drawer.emplace(context, state->scene, state->plan, state->programs, state->device, stats);
    state->isStateful = state->mayShowEarlierFrames();
    state->drawer->setPictureSize(width, height);
    state->drawer->setView(state->view);
    if (options.skip && grid.tiles.size() > 1) state->drawer->leaveOutOfTile(state->options.samples);
    if (options.skip && !options.floatPixels) state->drawer->leaveOutBlending();
    state->device.releaseMeshes();

    Result<gpu::Target> window = gpu::Target::window(
        capabilities, state->tiles.front().width, state->tiles.front().height,
        options.floatPixels ? gpu::TexelFormat::rgba32f : gpu::TexelFormat::rgba8, state->options.samples);
    append(diagnostics, std::move(window.diagnostics));
    if (!window) return refuse(std::move(diagnostics));
    state->window = std::move(window.value);
    if (options.axes) {
        Result<Axes> axes = Axes::create(context);
        append(diagnostics, std::move(axes.diagnostics));
        state->axes = std::move(axes.value);
    }
    append(diagnostics, context.debugLog().takeDiagnostics());
    applyStrict(diagnostics, options.strict);
    if (hasError(diagnostics)) return refuse(std::move(diagnostics));
    return {SceneRenderer(std::move(state)), std::move(diagnostics)};
}

Diagnostics SceneRenderer::State::drawTile(std::size_t index, double time, image::Image& picture,
                                           Stats& stats) {
    const Tile& tile = tiles[index];
    const Tile& part = parts[index];
    Diagnostics diagnostics;
    {
        const StageTimer timer(stats, "draw");
        const bool textures = index == 0 || !drawer->texturesComeFirst();
        append(diagnostics, drawer->draw(*window, tile, time, textures));
        if (axes) axes->draw(scene, view, tile, width, height);
        window->resolve();
    }
    const StageTimer timer(stats, "readback");
    const gpu::PixelLayout layout{
        picture.components, picture.type == image::Component::f32 ? gpu::TexelType::f32 : gpu::TexelType::u8};
    const gpu::PixelRectangle rectangle{part.x - tile.x, part.y - tile.y, part.width, part.height};
    if (tiles.size() == 1) {
        append(diagnostics, gpu::readPixels(context.capabilities(), window->readable(), 0, rectangle, layout,
                                            picture.data));
        return diagnostics;
    }
    const auto pixels = gpu::readPixels(context.capabilities(), window->readable(), 0, rectangle, layout);
    append(diagnostics, pixels.diagnostics);
    if (pixels) pasteTile(*pixels, part, picture);
    return diagnostics;
}

Result<image::Image> SceneRenderer::draw(double time, Stats& stats) {
    State& state = *state_;
    image::Image picture;
    picture.width = state.width;
    picture.height = state.height;
    picture.components = state.options.alpha ? 4 : 3;
    picture.type = state.options.floatPixels ? image::Component::f32 : image::Component::u8;
    picture.data.resize(picture.rowBytes() * static_cast<std::size_t>(picture.height));
    Diagnostics diagnostics;
    for (std::size_t i = 0; i < state.tiles.size() && !hasError(diagnostics); ++i)
        append(diagnostics, state.drawTile(i, time, picture, stats));
    stats.add("frames", 1);
    append(diagnostics, state.context.debugLog().takeDiagnostics());
    applyStrict(diagnostics, state.options.strict);
    if (hasError(diagnostics)) return diagnostics;
    return {std::move(picture), std::move(diagnostics)};
}

Result<image::Image> SceneRenderer::drawFirst(std::size_t draws, std::size_t pass, int color, double time,
                                              Stats& stats) {
    State& state = *state_;
    state.drawer->setDrawLimit(draws);
    Result<image::Image> window = draw(time, stats);
    state.drawer->setDrawLimit(std::numeric_limits<std::size_t>::max());
    const scene::Pass& drawn = *state.plan.passes[pass].pass;
    if (!window || drawn.targets.empty()) return window;
    const Result<const gpu::Target*> target = state.device.target(drawn);
    if (!target) return target.diagnostics;
    image::Image content{(*target)->width(), (*target)->height(), 4, image::Component::f32, {}};
    auto pixels = gpu::readPixels(state.context.capabilities(), (*target)->readable(), color,
                                  {0, 0, content.width, content.height}, {4, gpu::TexelType::f32});
    if (!pixels) return std::move(pixels.diagnostics);
    content.data = std::move(*pixels);
    return {std::move(content), std::move(window.diagnostics)};
}

namespace {

const char* suffix(glsl::Stage stage) {
    switch (stage) {
        case glsl::Stage::vertex:
            return "vert";
        case glsl::Stage::tessControl:
            return "tesc";
        case glsl::Stage::tessEvaluation:
            return "tese";
        case glsl::Stage::geometry:
            return "geom";
        case glsl::Stage::fragment:
            break;
    }
    return "frag";
}

/// The source without what only this driver takes: names of files in #line become their plain numbers.
std::string portable(std::string_view source) {
    std::string text;
    for (std::size_t begin = 0; begin < source.size();) {
        const std::size_t end = std::min(source.find('\n', begin), source.size());
        const std::string_view line = source.substr(begin, end - begin);
        if (line.starts_with("#line "))
            std::copy_if(line.begin(), line.end(), std::back_inserter(text), [](char c) { return c != '"'; });
        else if (line.find("GL_ARB_shading_language_include") == std::string_view::npos)
            text += line;
        text += '\n';
        begin = end + 1;
    }
    return text;
}

std::vector<TranslatedShader> translatedShaders(const scene::Scene& scene, const plan::FramePlan& plan) {
    std::vector<TranslatedShader> shaders;
    for (std::size_t i = 0; i < plan.programs.size(); ++i) {
        const int program = plan.programs[i].variant.program;
        std::string name =
            program == scene::kNone ? "built-in" : scene.programs[static_cast<std::size_t>(program)].name;
        for (char& c : name)
            if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
        for (const glsl::TranslatedStage& each : plan.programs[i].interface->facts.stages)
            shaders.push_back({fmt::format("{}-{}.{}", i, name, suffix(each.stage)), portable(each.source)});
    }
    return shaders;
}

}  // namespace

CheckResult checkScene(gpu::Context& context, const std::filesystem::path& path,
                       const RenderOptions& options) {
    Stats stats;
    CheckResult result;
    Result<scene::Scene> interpreted = interpretFile(path, options, stats);
    result.diagnostics = std::move(interpreted.diagnostics);
    if (interpreted) {
        // A scene with errors in its text is checked further as far as it goes: its shaders may be wrong too.
        SceneRenderer::State state(context, options, std::move(*interpreted), false, stats, nullptr);
        append(result.diagnostics, state.preparePlan(stats, true));
        result.shaders = translatedShaders(state.scene, state.plan);
    }
    append(result.diagnostics, context.debugLog().takeDiagnostics());
    applyStrict(result.diagnostics, options.strict);
    return result;
}

}  // namespace glibra::render
