#include "view/scene/pick.h"

#include <glad/gl.h>

#include <algorithm>
#include <vector>

#include "gpu/object/query.h"
#include "scene/matrices.h"

namespace glibra::view {
namespace {

/// Index of the draw among all draws into the window, skipped ones included.
int ordinalOf(const scene::Scene& scene, scene::StepIndex wanted) {
    int ordinal = 0;
    for (std::size_t pass = 0; pass <= wanted.pass; ++pass) {
        if (!scene.frame.passes[pass].isWindow) continue;
        const auto& steps = scene.frame.passes[pass].steps;
        for (std::size_t step = 0; step < steps.size() && scene::StepIndex{pass, step} < wanted; ++step)
            if (std::holds_alternative<scene::Draw>(steps[step])) ++ordinal;
    }
    return ordinal;
}

struct Counted {
    const plan::PlannedDraw* draw = nullptr;
    gpu::Query query{GL_SAMPLES_PASSED};
};

}  // namespace

std::optional<Picked> pick(LiveScene& scene, const gpu::Target& picture, double time, int x, int y) {
    if (x < 0 || y < 0 || x >= picture.width() || y >= picture.height()) return std::nullopt;
    const int row = picture.height() - 1 - y;
    std::vector<Counted> counted;
    {
        scene.drawer().limitTo(gpu::PixelRectangle{x, row, 1, 1});
        scene.drawer().setDrawHook([&](const plan::PlannedDraw& draw, bool isWindow, bool begins) {
            if (!isWindow) return;
            if (!begins) return counted.back().query.end();
            counted.push_back({&draw});
            counted.back().query.begin();
        });
        const int width = picture.width(), height = picture.height();
        scene.drawer().draw(picture, {scene.view(), width, height, {0, 0, width, height}, time, false});
        scene.drawer().setDrawHook({});
        scene.drawer().limitTo({});
    }
    float depth = 1;
    picture.readable().bindForReading();
    glReadPixels(x, row, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    if (depth >= 1) return std::nullopt;

    int last = -1;
    for (std::size_t i = 0; i < counted.size(); ++i) {
        if (counted[i].query.result() > 0) last = static_cast<int>(i);
    }
    if (last < 0) return std::nullopt;
    const plan::PlannedDraw& found = *counted[static_cast<std::size_t>(last)].draw;
    const scene::Draw& draw = scene.plan().drawOf(found);
    const double aspect = static_cast<double>(picture.width()) / picture.height();
    const glm::dvec4 clip((x + .5) / picture.width() * 2 - 1, (row + .5) / picture.height() * 2 - 1,
                          depth * 2.0 - 1, 1);
    const glm::dvec4 eye = scene::inverseOrZero(scene.view().projection(draw.projection, aspect)) * clip;
    Picked picked{.draw = draw.id, .ordinal = ordinalOf(scene.scene(), found.step), .word = draw.word};
    if (eye.w == 0) return picked;
    picked.eye = glm::dvec3(eye) / eye.w;
    picked.point = glm::dvec3(scene::inverseOrZero(scene.view().modelView(draw)) * glm::dvec4(picked.eye, 1));
    picked.centre = picked.point;
    if (const render::VertexBox* box = scene.boxOf(found)) {
        picked.centre = glm::dvec3(box->low + box->high) / 2.0;
        picked.half = glm::dvec3(box->high - box->low) / 2.0;
    }
    return picked;
}

}  // namespace glibra::view
