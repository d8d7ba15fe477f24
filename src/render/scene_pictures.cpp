// Draws the pictures of a SceneState.

#include <algorithm>
#include <utility>

#include "gpu/object/readback.h"
#include "render/consequences.h"
#include "render/draw/incomplete_mark.h"
#include "render/draw/tiles.h"
#include "render/scene_state.h"

namespace glibra::render {

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
