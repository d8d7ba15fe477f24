// Makes the plan of a scene and puts on the device what it needs.

#include "render/scene_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "gpu/object/readback.h"
#include "plan/accesses.h"
#include "plan/planner.h"
#include "render/consequences.h"
#include "render/draw/sight.h"
#include "render/load/open_loops.h"
#include "scene/primitives.h"
#include "scene/textures.h"

namespace glibra::render {
namespace {

constexpr std::array<float, 4> kYellow{1.F, 0.8F, 0.F, 1.F};
constexpr std::array<float, 4> kBlack{0.F, 0.F, 0.F, 1.F};

void setPixel(image::Image& picture, int x, int y, const std::array<float, 4>& color) {
    const bool isFloat = picture.type == image::Component::f32;
    const std::size_t size = isFloat ? sizeof(float) : 1;
    const auto components = static_cast<std::size_t>(picture.components);
    std::byte* pixel = picture.data.data() + static_cast<std::size_t>(y) * picture.rowBytes() +
                       static_cast<std::size_t>(x) * components * size;
    for (std::size_t i = 0; i < components; ++i)
        if (isFloat)
            std::memcpy(pixel + i * size, &color.at(i), size);
        else
            pixel[i] = static_cast<std::byte>(color.at(i) * 255.F);
}

/// Draws a border of black and yellow stripes over the edge of the picture: a fortieth of its smaller side
/// wide, at least 4 pixels. A picture of less than 16 pixels a side is covered by it.
void markIncomplete(image::Image& picture) {
    if (picture.type == image::Component::u16 || picture.components > 4) return;
    const int width = std::max(4, std::min(picture.width, picture.height) / 40);
    for (int y = 0; y < picture.height; ++y) {
        const bool isEdgeRow = y < width || y >= picture.height - width;
        for (int x = 0; x < picture.width; ++x) {
            if (!isEdgeRow && x == width && picture.width > 2 * width) x = picture.width - width;
            setPixel(picture, x, y, (x + y) / (2 * width) % 2 == 0 ? kYellow : kBlack);
        }
    }
}

/// Larger pictures are drawn in tiles, so that the use of device memory is bounded: 8192 x 8192.
constexpr std::int64_t kMostPixelsAtOnce = std::int64_t{1} << 26;
constexpr std::int64_t kMostPixels = std::int64_t{1} << 30;

}  // namespace

SceneState::SceneState(gpu::Context& usedContext, const RenderOptions& usedOptions,
                       InterpretedScene interpreted, bool isTiled, Stats& stats, SharedParts* shared)
    : conductor(usedContext, usedOptions, std::move(interpreted), stats,
                {.isTiled = isTiled,
                 .hasProbes = usedOptions.maxError > 0 && usedOptions.skip,
                 .shared = shared,
                 .watchesLoops = true,
                 .onError = usedOptions.incomplete ? OnError::mark : OnError::stop,
                 .interpreted = [this] { conductor.lookFrom(conductor.options.viewState); },
                 .request = [this] { return request(); },
                 .planned =
                     [this](bool isFirst) {
                         if (isFirst) listSkipped();
                         return std::exchange(ofMeshes_, {});
                     },
                 .simulationPlanned = [this] { explainSimulation(); },
                 .equip = [this](FrameDrawer& drawer) { equip(drawer); }}) {}

Result<std::unique_ptr<SceneState>> SceneState::of(gpu::Context& context, InterpretedScene interpreted,
                                                   const RenderOptions& options, Stats& stats,
                                                   SharedParts* shared) {
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

    auto state = std::make_unique<SceneState>(context, options, std::move(interpreted),
                                              grid.tiles.size() > 1 || options.tileSize > 0, stats,
                                              options.skip ? shared : nullptr);
    state->width = width;
    state->height = height;
    state->tiles = std::move(grid.tiles);
    state->tileParts = std::move(grid.parts);
    Diagnostics diagnostics;
    state->conductor.placeEye(static_cast<double>(width) / height, diagnostics, stats);
    state->conductor.lookFrom(options.viewState);
    return {std::move(state), std::move(diagnostics)};
}

Result<std::unique_ptr<SceneState>> SceneState::load(gpu::Context& context, InterpretedScene interpreted,
                                                     const RenderOptions& options, Stats& stats,
                                                     SharedParts* shared) {
    Result<std::unique_ptr<SceneState>> made = of(context, std::move(interpreted), options, stats, shared);
    if (!made) return made;
    append(made.diagnostics, (*made)->conductor.prepare((*made)->request()));
    if (!(*made)->makeReady(made.diagnostics)) made.value.reset();
    return made;
}

Result<plan::PlanOptions> SceneState::planOptions(bool everything) {
    const RenderOptions& options = conductor.options;
    const scene::Scene& scene = conductor.scene;
    const gpu::Capabilities& driver = conductor.context.capabilities();
    Result<std::vector<plan::Override>> overrides = parseOverrides(options.set);
    if (!overrides) return std::move(overrides.diagnostics);
    plan::PlanOptions made = planOptionsOf(driver);
    made.overrides = std::move(*overrides);
    std::erase_if(made.overrides, [&](const plan::Override& each) {
        return each.program.empty() && scene.usedVariables.contains(each.name);
    });
    for (const std::string& each : options.wantedObjects) {
        const Result<scene::ObjectView> wanted = scene::objectNamed(scene, each);
        if (!wanted) return wanted.diagnostics;
        made.roots.push_back(*wanted);
    }
    if (options.checks) {
        for (const scene::Check& each : scene.checks)
            for (const scene::ObjectView& object : each.objects()) made.roots.push_back(object);
    }
    for (const scene::Print& each : scene.prints)
        for (const scene::ObjectView& object : each.objects()) made.roots.push_back(object);
    made.everything = everything || !options.skip;
    made.shareMeshes = options.skip;
    made.reportsNames = !conductor.hasBlocks();
    made.shareTargets = options.skip && !options.checkNan;  // the search looks into every target
    Diagnostics problems;
    if (options.checkUndefined && !driver.compute)
        problems.push_back(diagnose("check-E03",
                                    fmt::format("--check-undefined needs OpenGL 4.3; this driver has {}.{}",
                                                driver.major, driver.minor),
                                    {scene.path, 1, 1}));
    return {std::move(made), std::move(problems)};
}

Result<PlanRequest> SceneState::request(bool everything) {
    Result<plan::PlanOptions> planned = planOptions(everything);
    if (!planned) return std::move(planned.diagnostics);
    if (choose) append(planned.diagnostics, choose(*this, *planned));
    RenderOptions& options = conductor.options;
    options.samples = std::max(1, options.samples);
    // Primitives out of sight count, too.
    const bool countsPrimitives =
        options.checks && std::ranges::any_of(conductor.scene.checks, [](const auto& each) {
            return each.kind == scene::Check::Kind::primitives;
        });
    PlanRequest made{std::move(*planned), {}, conductor.changesWithTime};
    if (!made.options.everything && !countsPrimitives)
        made.outOfSight = [this](const scene::Draw& draw, const scene::Pass& pass) {
            return outOfSight(draw, pass, &ofMeshes_);
        };
    return {std::move(made), std::move(planned.diagnostics)};
}

void SceneState::listSkipped() {
    Stats& stats = conductor.loadStats;
    const plan::FramePlan& plan = conductor.plan;
    stats.skipped.insert(stats.skipped.begin(), plan.skipped.begin(), plan.skipped.end());
    std::set<std::pair<scene::ProgramIndex, std::string>> seen;  // draws may have variants of a program
    for (const plan::PlannedProgram& each : plan.programs)
        for (const std::string& found : each.foundByName)
            if (seen.emplace(each.variant.program, found).second) {
                const scene::Program& program = conductor.scene.programs[each.variant.program];
                stats.foundByName.push_back({"'" + program.name + "'", found, program.place});
            }
}

/// Nodes of all lists may be skipped; what one of them uses is not.
void SceneState::explainSimulation() {
    Stats& stats = conductor.loadStats;
    const scene::Scene& scene = conductor.scene;
    const std::optional<Simulation>& simulation = conductor.simulation;
    std::vector<Place> used;
    for (const plan::FramePlan* each : simulation->plans()) {
        for (const plan::PlannedProgram& program : each->programs) {
            if (!program.variant.program) continue;
            const scene::Program& own = scene.programs[program.variant.program];
            used.push_back(own.place);
            for (const scene::StageFile& stage : own.stages)
                if (stage.file) used.push_back(scene.files[stage.file].place);
        }
        for (const scene::TextureIndex texture : each->textures)
            used.push_back(scene.textures[texture].place);
        for (const scene::BufferIndex buffer : each->buffers) {
            const scene::Buffer& own = scene.buffers[buffer];
            used.push_back(own.place);
            if (own.file) used.push_back(scene.files[own.file].place);
        }
    }
    const auto isNode = [](const plan::Skipped& each) {
        return each.what == "pass" || each.what == "draw" || each.what == "dispatch" ||
               each.what == "statement";
    };
    std::erase_if(stats.skipped, [&](const plan::Skipped& each) {
        return !isNode(each) && std::ranges::find(used, each.place) != used.end();
    });
    for (const plan::FramePlan* each : simulation->plans())
        std::copy_if(each->skipped.begin(), each->skipped.end(), std::back_inserter(stats.skipped), isNode);
}

std::string SceneState::outOfSight(const scene::Draw& draw, const scene::Pass& pass, Diagnostics* remarks) {
    const scene::Scene& scene = conductor.scene;
    const RenderOptions& options = conductor.options;
    const geometry::Topology topology = scene::topologyOf(scene.shapes[draw.shape]);
    const plan::ProgramVariant variant = plan::variantOf(scene, draw, pass);
    const glsl::Placement placement = conductor.programs.placementOf(variant);
    if (topology == geometry::Topology::patches || placement == glsl::Placement::unknown ||
        !isPlacedByMatrices(draw) || scene.shapes[draw.shape].bare)
        return {};
    Screen screen{width, height, {0, 0, width, height}, options.samples, options.tileSize > 0};
    if (!pass.isWindow) {
        const auto size = scene::targetSize(scene, pass);
        if (!size) return {};
        const auto [targetWidth, targetHeight] = *size;
        const int samples = pass.targets.empty() ? scene.textures[pass.depth->texture].samples
                                                 : scene.textures[pass.targets.front()].samples;
        screen = {
            targetWidth, targetHeight, {0, 0, targetWidth, targetHeight}, samples, options.tileSize > 0};
    }
    const VertexBox& bounds =
        conductor.device.meshes().bounds(draw.shape, conductor.programs.mayReadTangents(variant), remarks);
    const ViewMatrices seen =
        isMoved(scene.frame, pass) ? conductor.view.shifted(pass.shift) : conductor.view.unmoved();
    const DrawView drawView = drawViewOf(draw, topology, seen, screen, conductor.context.capabilities());
    return std::string(describe(sightOf(placed(bounds, placement), drawView)));
}

/// Every tile would run the effects again.
Diagnostics SceneState::checkTiles() const {
    if (tiles.size() == 1) return {};
    Diagnostics found;
    const plan::FramePlan& plan = conductor.plan;
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

void SceneState::equip(FrameDrawer& drawer) {
    const RenderOptions& options = conductor.options;
    conductor.recordLoops(conductor.plan);
    if (options.skip && tiles.size() > 1) drawer.cullToTile(options.samples);
    if (options.skip && !options.floatPixels) drawer.skipOpaqueBlending();
    if (areSamplesChosen && options.samples > 1) drawer.shadeSamples();
    if (gpuTimes) gpuTimes->watch(drawer, conductor.scene, conductor.plan);
}

bool SceneState::makeReady(Diagnostics& diagnostics) {
    const RenderOptions& options = conductor.options;
    const auto refuse = [&] {
        conductor.judge(diagnostics);
        return false;
    };
    explainRemovedLoops(conductor.scene, conductor.plan, conductor.programs, diagnostics);
    conductor.judge(diagnostics);
    conductor.note(diagnostics);
    if (conductor.stopsWith(diagnostics)) return false;

    const Diagnostics ofTiles = checkTiles();
    append(diagnostics, ofTiles);
    if (hasError(ofTiles)) return refuse();
    conductor.makeDrawer();
    conductor.device.meshes().release();

    Result<gpu::Target> made =
        gpu::Target::window(conductor.context.capabilities(), tiles.front().width, tiles.front().height,
                            options.floatPixels ? gpu::TexelFormat::rgba32f : gpu::TexelFormat::rgba8,
                            options.samples, depthFormat(conductor.scene.reversesWindow));
    append(diagnostics, std::move(made.diagnostics));
    if (!made) return refuse();
    window = std::move(made.value);
    if (options.axes) append(diagnostics, conductor.makeAxes());
    append(diagnostics, conductor.context.debugLog().takeDiagnostics());
    conductor.judge(diagnostics);
    conductor.note(diagnostics);
    return !conductor.stopsWith(diagnostics);
}

// Draws the pictures of a SceneState.

Diagnostics SceneState::moveTo(double time, Stats& stats) {
    Diagnostics diagnostics;
    scene::FrameInputs wanted = conductor.inputs;
    wanted.time = time;
    if (conductor.changesWithTime) conductor.moveTo(wanted, diagnostics, stats);
    conductor.inputs.time = time;
    if (!conductor.stopsWith(diagnostics)) append(diagnostics, conductor.simulate());
    conductor.note(diagnostics);
    return diagnostics;
}

void SceneState::drawTile(std::size_t index, Diagnostics& diagnostics, Stats& stats) {
    const StageTimer timer(stats, "draw");
    conductor.draw(*window, {width, height, tiles[index], index == 0, conductor.options.axes}, diagnostics);
    const bool isTimed = gpuTimes != nullptr && window->samples() > 1;
    if (isTimed) gpuTimes->beginWork({"means of the window's samples", 0});
    window->resolve();
    if (isTimed) gpuTimes->endWork();
}

Diagnostics SceneState::readTile(std::size_t index, image::Image& picture, Stats& stats) {
    const Tile& tile = tiles[index];
    const Tile& part = tileParts[index];
    const StageTimer timer(stats, "readback");
    const gpu::PixelRectangle rectangle{part.x - tile.x, part.y - tile.y, part.width, part.height};
    if (tiles.size() == 1)
        return gpu::readPixels(conductor.context.capabilities(), window->readable(), 0, rectangle,
                               pixelLayout(), picture.data);
    auto pixels =
        gpu::readPixels(conductor.context.capabilities(), window->readable(), 0, rectangle, pixelLayout());
    if (pixels) pasteTile(*pixels, part, picture);
    return std::move(pixels.diagnostics);
}

SceneState::Finish SceneState::finish() const {
    Finish finish{.labels = std::nullopt, .isIncomplete = conductor.condition == Condition::incomplete};
    if (const LabelCorner corner = conductor.options.labels; corner != LabelCorner::none)
        finish.labels = labelBlock(width, height, labelsOf(conductor.scene, conductor.plans()), corner);
    return finish;
}

image::Image SceneState::Finish::finished(image::Image picture) const {
    if (labels) drawLabels(picture, *labels, labels->left, labels->top);
    if (isIncomplete) markIncomplete(picture);
    return picture;
}

image::Image SceneState::emptyPicture() const {
    image::Image picture{width,
                         height,
                         conductor.options.alpha ? 4 : 3,
                         conductor.options.floatPixels ? image::Component::f32 : image::Component::u8,
                         {}};
    picture.data.resize(picture.rowBytes() * static_cast<std::size_t>(height));
    return picture;
}

gpu::PixelLayout SceneState::pixelLayout() const {
    return {conductor.options.alpha ? 4 : 3,
            conductor.options.floatPixels ? gpu::TexelType::f32 : gpu::TexelType::u8};
}

void SceneState::endFrame(Diagnostics& diagnostics, Stats& stats) {
    conductor.noteDrawn(width, height, diagnostics);
    append(diagnostics, conductor.takeCutLoops());
    stats.add("frames", 1);
    append(diagnostics, conductor.context.debugLog().takeDiagnostics());
    if (conductor.options.checkUndefined) append(diagnostics, conductor.programs.takeUndefined());
    conductor.judge(diagnostics);
    conductor.note(diagnostics);
}

Result<image::Image> SceneState::draw(double time, Stats& stats) {
    image::Image picture = emptyPicture();
    Diagnostics diagnostics = moveTo(time, stats);
    for (std::size_t i = 0; i < tiles.size() && !conductor.stopsWith(diagnostics); ++i) {
        drawTile(i, diagnostics, stats);
        append(diagnostics, readTile(i, picture, stats));
    }
    endFrame(diagnostics, stats);
    if (conductor.stopsWith(diagnostics)) return diagnostics;
    return {finish().finished(std::move(picture)), std::move(diagnostics)};
}

// Makes parts of a scene before its programs are compiled. Only the compiler knows which samplers a program
// keeps; this code assumes all that the sources use. A wrong guess costs time on an otherwise idle thread and
// nothing else: the plan uses what it needs and makes what is missing.

namespace {

/// The words of a GLSL text, in order.
std::vector<std::string_view> wordsOf(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t begin = i;
        while (i < text.size() && base::isOfName(text[i])) ++i;
        if (i > begin)
            words.push_back(text.substr(begin, i - begin));
        else
            ++i;
    }
    return words;
}

std::optional<scene::TextureTarget> textureTargetOf(std::string_view samplerType) {
    if (samplerType == "sampler1D") return scene::TextureTarget::texture1D;
    if (samplerType == "sampler2D") return scene::TextureTarget::texture2D;
    if (samplerType == "sampler3D") return scene::TextureTarget::texture3D;
    if (samplerType == "samplerCube") return scene::TextureTarget::cube;
    return std::nullopt;
}

/// The samplers that a stage declares and uses, as if the compiler had kept them.
plan::ProgramInterface samplersIn(const glsl::TranslatedProgram& program) {
    plan::ProgramInterface guess;
    for (const glsl::TranslatedStage& stage : program.stages) {
        if (stage.source.find("sampler") == std::string::npos) continue;
        const std::vector<std::string_view> words = wordsOf(stage.source);
        for (std::size_t i = 1; i + 1 < words.size(); ++i) {
            const std::optional<scene::TextureTarget> target = textureTargetOf(words[i]);
            if (!target || words[i - 1] != "uniform" || std::ranges::count(words, words[i + 1]) < 2) continue;
            plan::ActiveUniform& sampler = guess.uniforms.emplace_back();
            sampler.name = words[i + 1];
            if (const auto renamed = program.userNames.find(sampler.name); renamed != program.userNames.end())
                sampler.name = renamed->second;
            sampler.type.base = plan::BaseType::sampler;
            sampler.type.target = target;
            sampler.type.word = words[i];
        }
    }
    guess.facts = program;
    guess.usable = true;
    return guess;
}

}  // namespace

void SceneState::makeAhead() {
    const RenderOptions& options = conductor.options;
    const scene::Scene& scene = conductor.scene;
    ProgramLibrary& programs = conductor.programs;
    DeviceScene& device = conductor.device;
    if (options.maxError > 0) return;  // shapes are chosen after the programs are compiled
    Result<std::vector<plan::Override>> overrides = parseOverrides(options.set);
    if (!overrides) return;
    std::erase_if(*overrides, [](const plan::Override& each) { return !each.word.empty(); });
    std::map<plan::ProgramVariant, plan::ProgramInterface> guesses;
    const auto answer = [&](const plan::Questions& asked, plan::Answers& answers) {
        for (const plan::ProgramVariant& each : asked.interfaces) {
            const glsl::TranslatedProgram* translated = programs.translated(each);
            const bool isKnown = each.program && translated && !hasError(translated->diagnostics);
            const auto guess =
                guesses.emplace(each, isKnown ? samplersIn(*translated) : plan::ProgramInterface()).first;
            answers.interfaces.emplace(each, &guess->second);
        }
        for (const scene::ProgramIndex each : asked.writers)
            answers.writers.emplace(each, programs.mayWriteImages(each));
        answers.loopLimit = 0;
        for (const scene::StepIndex& each : asked.unseen)
            answers.sight.add(each,
                              outOfSight(scene.frame.draw(each), scene.frame.passes[each.pass], nullptr));
    };
    plan::PlanOptions planOptions = planOptionsOf(conductor.context.capabilities());
    planOptions.overrides = std::move(*overrides);
    planOptions.lacksCompute = "nothing of it is known before its programs are compiled";
    planOptions.reportsNames = false;
    const plan::FramePlan guessed = plan::planFrame(scene, scene.frame, {}, planOptions, answer);
    guessed.visitDraws([&](const plan::PlannedDraw& planned, const scene::Draw& draw, const auto&) {
        const plan::ProgramVariant& variant = guessed.programs[planned.program].variant;
        device.meshes().bounds(draw.shape, programs.mayReadTangents(variant), nullptr);
    });
    for (const scene::TextureIndex each : guessed.textures) device.textures().readAhead(each);
}

}  // namespace glibra::render
