#include "view/scene/window_target.h"

#include <glad/gl.h>

#include <algorithm>
#include <utility>

#include "gpu/object/timer.h"
#include "scene/view.h"

namespace glibra::view {

std::vector<const scene::Draw*> windowDraws(const scene::Scene& scene) {
    std::vector<const scene::Draw*> draws;
    for (const scene::Pass& pass : scene.frame.passes) {
        if (!pass.isWindow) continue;
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<scene::Draw>(&step)) draws.push_back(draw);
    }
    return draws;
}

const plan::PlannedDraw* visibleDraw(render::LiveScene& scene, const gpu::Target& picture, double time, int x,
                                     int row) {
    std::vector<std::pair<const plan::PlannedDraw*, gpu::Query>> counted;
    render::FrameDrawer& drawer = scene.drawer();
    drawer.limitTo(gpu::PixelRectangle{x, row, 1, 1});
    drawer.setDrawHook([&](const plan::PlannedDraw& draw, bool isWindow, bool begins) {
        if (!isWindow) return;
        if (!begins) return counted.back().second.end();
        counted.emplace_back(&draw, gpu::Query(GL_SAMPLES_PASSED));
        counted.back().second.begin();
    });
    const int width = picture.width(), height = picture.height();
    drawer.draw(picture, {scene.view(), width, height, {0, 0, width, height}, time, false});
    drawer.setDrawHook({});
    drawer.limitTo({});
    const plan::PlannedDraw* found = nullptr;
    for (const auto& [draw, query] : counted)
        if (query.result() > 0) found = draw;
    return found;
}

std::optional<Picked> pick(render::LiveScene& scene, const gpu::Target& picture, double time, int x, int y) {
    if (x < 0 || y < 0 || x >= picture.width() || y >= picture.height()) return std::nullopt;
    const int row = picture.height() - 1 - y;
    const plan::PlannedDraw* found = visibleDraw(scene, picture, time, x, row);
    float stored = 1;
    picture.readable().bindForReading();
    glReadPixels(x, row, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &stored);
    if (found == nullptr) return std::nullopt;
    const scene::Draw& draw = scene.plan().drawOf(*found);
    const bool isReversed = draw.raster->depthOrder != base::DepthOrder::usual;
    const double depth = isReversed ? 1.0 - stored : stored;
    if (isReversed ? stored <= 0 : stored >= 1) return std::nullopt;
    const double aspect = static_cast<double>(picture.width()) / picture.height();
    const glm::dvec4 clip((x + .5) / picture.width() * 2 - 1, (row + .5) / picture.height() * 2 - 1,
                          depth * 2 - 1, 1);
    const glm::dvec4 eye = scene::inverseOrZero(scene.view().projection(*draw.projection, aspect)) * clip;
    const std::vector<const scene::Draw*> all = windowDraws(scene.scene());
    const auto ordinal = static_cast<int>(std::ranges::find(all, &draw) - all.begin());
    Picked picked{.draw = draw.id, .ordinal = ordinal, .word = draw.word};
    if (eye.w == 0) return picked;
    picked.eye = glm::dvec3(eye) / eye.w;
    picked.point = glm::dvec3(scene::inverseOrZero(scene.view().modelView(draw)) * glm::dvec4(picked.eye, 1));
    picked.centre = picked.point;
    if (const render::VertexBox* box = scene.boxOf(*found)) {
        picked.centre = glm::dvec3(box->low + box->high) / 2.0;
        picked.half = glm::dvec3(box->high - box->low) / 2.0;
    }
    return picked;
}

}  // namespace glibra::view
