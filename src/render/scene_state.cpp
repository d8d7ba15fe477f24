// Makes the plan of a scene and puts on the device what it needs.

#include "render/scene_state.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <set>
#include <utility>

#include "gpu/object/readback.h"
#include "image/image.h"
#include "plan/accesses.h"
#include "render/consequences.h"
#include "render/draw/sight.h"
#include "render/draw/tiles.h"
#include "render/load/open_loops.h"
#include "scene/primitives.h"
#include "scene/texture_name.h"
#include "scene/texture_parts.h"

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
    state->placeEye(static_cast<double>(width) / height, diagnostics, stats);
    state->lookFrom(options.viewState);
    return {std::move(state), std::move(diagnostics)};
}

Result<std::unique_ptr<SceneState>> SceneState::load(gpu::Context& context, InterpretedScene interpreted,
                                                     const RenderOptions& options, Stats& stats,
                                                     SharedParts* shared) {
    Result<std::unique_ptr<SceneState>> made = of(context, std::move(interpreted), options, stats, shared);
    if (!made) return made;
    append(made.diagnostics, (*made)->preparePlan((*made)->planOptions(false), stats));
    if (!(*made)->makeReady(made.diagnostics, stats)) made.value.reset();
    return made;
}

bool SceneState::isStopped(const Diagnostics& diagnostics) {
    if (!hasError(diagnostics)) return false;
    isIncomplete = options.incomplete;
    return isBroken || !options.incomplete;
}

Result<plan::PlanOptions> SceneState::planOptions(bool everything) {
    isBroken = true;  // until there is a plan
    Result<std::vector<plan::Override>> overrides = parseOverrides(options.set);
    if (!overrides) return std::move(overrides.diagnostics);
    plan::PlanOptions made = planOptionsOf(context.capabilities());
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
            for (const auto& object : {each.object, each.other})
                if (object) made.roots.push_back(*object);
        for (const scene::Check& check : scene.checks)
            for (const scene::BufferIndex each : check.reads)
                made.roots.emplace_back(scene::BufferView{each});
    }
    for (const scene::Print& each : scene.prints) made.roots.emplace_back(each.buffer);
    made.everything = everything || !options.skip;
    made.shareMeshes = options.skip;
    made.reportsNames = !hasBlocks();
    made.shareTargets = options.skip && !options.checkNan;  // the search looks into every target
    Diagnostics problems;
    if (options.checkUndefined && !context.capabilities().compute)
        problems.push_back(diagnose("check-E03",
                                    fmt::format("--check-undefined needs OpenGL 4.3; this driver has {}.{}",
                                                context.capabilities().major, context.capabilities().minor),
                                    {scene.path, 1, 1}));
    return {std::move(made), std::move(problems)};
}

Diagnostics SceneState::preparePlan(Result<plan::PlanOptions> asked, Stats& stats) {
    Diagnostics diagnostics = std::move(asked.diagnostics);
    if (!asked) return diagnostics;
    options.samples = std::max(1, options.samples);
    Diagnostics meshDiagnostics;
    // Primitives out of sight count, too.
    const bool countsPrimitives = options.checks && std::ranges::any_of(scene.checks, [](const auto& each) {
                                      return each.kind == scene::Check::Kind::primitives;
                                  });
    OutOfSight unseen;
    if (!asked->everything && !countsPrimitives)
        unseen = [&](const scene::Draw& draw, const scene::Pass& pass) {
            return outOfSight(draw, pass, &meshDiagnostics);
        };
    plan = planList(scene.frame, *asked, unseen);
    isBroken = false;
    if (!isMoving) {
        stats.skipped.insert(stats.skipped.begin(), plan.skipped.begin(), plan.skipped.end());
        listFoundByName(stats);
    }
    append(diagnostics, std::exchange(plan.diagnostics, {}));
    append(diagnostics, std::move(meshDiagnostics));
    const bool isFirst = !simulation;
    const auto add = [&](Diagnostics ofSteps) {
        isBroken = hasError(ofSteps);
        append(diagnostics, std::move(ofSteps));
    };
    if (!isStopped(diagnostics)) {
        add(planSimulation(*asked, changesWithTime));
        if (isFirst && simulation) explainSimulation(stats);
    }
    if (!isStopped(diagnostics)) append(diagnostics, device.prepare(plan, programs));
    if (!isStopped(diagnostics) && isFirst && simulation) add(simulation->make());
    return diagnostics;
}

/// Nodes of all lists may be skipped; what one of them uses is not.
void SceneState::explainSimulation(Stats& stats) const {
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

void SceneState::listFoundByName(Stats& stats) const {
    std::set<std::pair<scene::ProgramIndex, std::string>> seen;  // draws may have variants of a program
    for (const plan::PlannedProgram& each : plan.programs)
        for (const std::string& found : each.foundByName)
            if (seen.emplace(each.variant.program, found).second)
                stats.foundByName.push_back({"'" + scene.programs[each.variant.program].name + "'", found,
                                             scene.programs[each.variant.program].place});
}

std::string SceneState::outOfSight(const scene::Draw& draw, const scene::Pass& pass, Diagnostics* remarks) {
    const geometry::Topology topology = scene::topologyOf(scene.shapes[draw.shape]);
    const plan::ProgramVariant variant = plan::variantOf(scene, draw, pass);
    const glsl::Placement placement = programs.placementOf(variant);
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
    const VertexBox& bounds = device.meshes().bounds(draw.shape, programs.mayReadTangents(variant), remarks);
    const ViewMatrices seen = isMoved(scene.frame, pass) ? view.shifted(pass.shift) : view.unmoved();
    const DrawView drawView = drawViewOf(draw, topology, seen, screen, context.capabilities());
    return std::string(describe(sightOf(placed(bounds, placement), drawView)));
}

/// Every tile would run the effects again.
Diagnostics SceneState::checkTiles() const {
    if (tiles.size() == 1) return {};
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

void SceneState::makePictureDrawer(Stats& stats) {
    makeDrawer(stats);
    recordLoops(plan);
    if (options.skip && tiles.size() > 1) drawer->cullToTile(options.samples);
    if (options.skip && !options.floatPixels) drawer->skipOpaqueBlending();
    if (areSamplesChosen && options.samples > 1) drawer->shadeSamples();
    if (gpuTimes) gpuTimes->watch(*drawer, scene, plan);
}

bool SceneState::makeReady(Diagnostics& diagnostics, Stats& stats) {
    const auto refuse = [&] {
        applyStrict(diagnostics, options.strict);
        return false;
    };
    explainRemovedLoops(scene, plan, programs, diagnostics);
    applyStrict(diagnostics, options.strict);
    if (isStopped(diagnostics)) return false;

    const Diagnostics ofTiles = checkTiles();
    append(diagnostics, ofTiles);
    if (hasError(ofTiles)) return refuse();
    makePictureDrawer(stats);
    device.meshes().release();

    Result<gpu::Target> made =
        gpu::Target::window(context.capabilities(), tiles.front().width, tiles.front().height,
                            options.floatPixels ? gpu::TexelFormat::rgba32f : gpu::TexelFormat::rgba8,
                            options.samples, kDepthFormat);
    append(diagnostics, std::move(made.diagnostics));
    if (!made) return refuse();
    window = std::move(made.value);
    if (options.axes) append(diagnostics, makeAxes());
    append(diagnostics, context.debugLog().takeDiagnostics());
    applyStrict(diagnostics, options.strict);
    return !isStopped(diagnostics);
}

// Draws the pictures of a SceneState.

Diagnostics SceneState::moveTo(double time, Stats& stats) {
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
        Result<plan::PlanOptions> asked = planOptions(false);
        if (asked && choose) append(asked.diagnostics, choose(*this, *asked, stats));
        append(diagnostics, preparePlan(std::move(asked), stats));
        if (isStopped(diagnostics)) return diagnostics;
    }
    if (simulation) append(diagnostics, simulation->advance(inputs));
    if (isOther && !isStopped(diagnostics)) makePictureDrawer(loadStats);
    return diagnostics;
}

Diagnostics SceneState::drawTile(std::size_t index, double time, const plan::StillNodes& still,
                                 Stats& stats) {
    const StageTimer timer(stats, "draw");
    const bool textures = index == 0 || !texturesComeFirst(plan);
    Diagnostics diagnostics = drawer->draw(*window, {.view = view,
                                                     .width = width,
                                                     .height = height,
                                                     .tile = tiles[index],
                                                     .time = time,
                                                     .texturePasses = textures,
                                                     .still = &still,
                                                     .recordsLoops = recordsLoops()});
    if (axes) axes->draw(*window, scene, view, tiles[index], width, height);
    const bool isTimed = gpuTimes != nullptr && window->samples() > 1;
    if (isTimed) gpuTimes->beginWork({"means of the window's samples", 0});
    window->resolve();
    if (isTimed) gpuTimes->endWork();
    return diagnostics;
}

Diagnostics SceneState::readTile(std::size_t index, image::Image& picture, Stats& stats) {
    const Tile& tile = tiles[index];
    const Tile& part = tileParts[index];
    const StageTimer timer(stats, "readback");
    const gpu::PixelRectangle rectangle{part.x - tile.x, part.y - tile.y, part.width, part.height};
    if (tiles.size() == 1)
        return gpu::readPixels(context.capabilities(), window->readable(), 0, rectangle, pixelLayout(),
                               picture.data);
    auto pixels = gpu::readPixels(context.capabilities(), window->readable(), 0, rectangle, pixelLayout());
    if (pixels) pasteTile(*pixels, part, picture);
    return std::move(pixels.diagnostics);
}

std::optional<LabelBlock> SceneState::labels() const {
    if (options.labels == LabelCorner::none) return std::nullopt;
    return labelBlock(width, height, labelsOf(scene, plans()), options.labels);
}

image::Image SceneState::emptyPicture() const {
    image::Image picture{width,
                         height,
                         options.alpha ? 4 : 3,
                         options.floatPixels ? image::Component::f32 : image::Component::u8,
                         {}};
    picture.data.resize(picture.rowBytes() * static_cast<std::size_t>(height));
    return picture;
}

gpu::PixelLayout SceneState::pixelLayout() const {
    return {options.alpha ? 4 : 3, options.floatPixels ? gpu::TexelType::f32 : gpu::TexelType::u8};
}

void SceneState::finishPicture(image::Image& picture, const std::optional<LabelBlock>& labels,
                               bool isIncomplete) {
    if (labels) drawLabels(picture, *labels, labels->left, labels->top);
    if (isIncomplete) markIncomplete(picture);
}

void SceneState::endFrame(Diagnostics& diagnostics, Stats& stats) {
    noteDrawn(width, height, diagnostics);
    append(diagnostics, takeCutLoops());
    stats.add("frames", 1);
    append(diagnostics, context.debugLog().takeDiagnostics());
    if (options.checkUndefined) append(diagnostics, programs.takeUndefined());
    applyStrict(diagnostics, options.strict);
}

Result<image::Image> SceneState::draw(double time, Stats& stats) {
    image::Image picture = emptyPicture();
    Diagnostics diagnostics = moveTo(time, stats);
    const plan::StillNodes still = hasError(diagnostics) ? plan::StillNodes() : stillNodes(width, height);
    for (std::size_t i = 0; i < tiles.size() && !isStopped(diagnostics); ++i) {
        append(diagnostics, drawTile(i, time, still, stats));
        append(diagnostics, readTile(i, picture, stats));
    }
    endFrame(diagnostics, stats);
    if (isStopped(diagnostics)) return diagnostics;
    finishPicture(picture, labels(), isIncomplete);
    return {std::move(picture), std::move(diagnostics)};
}

}  // namespace glibra::render
