#include "view/scene/pick.h"

#include <glad/gl.h>

#include <algorithm>
#include <vector>

#include "gpu/object/name.h"
#include "scene/matrices.h"

namespace glibra::view {
namespace {

void deleteQuery(GLuint name) {
    glDeleteQueries(1, &name);
}

/// Restricts drawing and clearing to one pixel during its lifetime.
class OnePixel {
  public:
    OnePixel(int x, int y) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(x, y, 1, 1);
    }
    OnePixel(const OnePixel&) = delete;
    OnePixel& operator=(const OnePixel&) = delete;
    ~OnePixel() { glDisable(GL_SCISSOR_TEST); }
};

/// Index of the draw among all draws into the window, skipped ones included.
int ordinalOf(const scene::Scene& scene, const scene::Draw& wanted) {
    int ordinal = 0;
    for (const scene::Pass& pass : scene.passes) {
        if (!pass.targets.empty()) continue;
        for (const auto& step : pass.steps) {
            const auto* draw = std::get_if<scene::Draw>(&step);
            if (draw == &wanted) return ordinal;
            if (draw != nullptr) ++ordinal;
        }
    }
    return ordinal;
}

struct Counted {
    const plan::PlannedDraw* draw = nullptr;
    gpu::Name<deleteQuery> query;
};

}  // namespace

std::optional<Picked> pick(LiveScene& scene, const gpu::Target& picture, double time, int x, int y) {
    if (x < 0 || y < 0 || x >= picture.width() || y >= picture.height()) return std::nullopt;
    const int row = picture.height() - 1 - y;
    std::vector<Counted> counted;
    {
        const OnePixel scissor(x, row);
        scene.drawer().setDrawHook([&](const plan::PlannedDraw& draw, bool isWindow, bool begins) {
            if (!isWindow) return;
            if (!begins) return glEndQuery(GL_SAMPLES_PASSED);
            GLuint name = 0;
            glGenQueries(1, &name);
            counted.push_back({&draw, gpu::Name<deleteQuery>(name)});
            glBeginQuery(GL_SAMPLES_PASSED, name);
        });
        const int width = picture.width(), height = picture.height();
        scene.drawer().draw(picture, {scene.view(), width, height, {0, 0, width, height}, time, false});
        scene.drawer().setDrawHook({});
    }
    float depth = 1;
    picture.readable().bindForReading();
    glReadPixels(x, row, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    if (depth >= 1) return std::nullopt;

    int last = -1;
    for (std::size_t i = 0; i < counted.size(); ++i) {
        GLuint samples = 0;
        glGetQueryObjectuiv(counted[i].query.get(), GL_QUERY_RESULT, &samples);
        if (samples > 0) last = static_cast<int>(i);
    }
    if (last < 0) return std::nullopt;
    const scene::Draw& draw = *counted[static_cast<std::size_t>(last)].draw->draw;
    const double aspect = static_cast<double>(picture.width()) / picture.height();
    const glm::dvec4 clip((x + .5) / picture.width() * 2 - 1, (row + .5) / picture.height() * 2 - 1,
                          depth * 2.0 - 1, 1);
    const glm::dvec4 eye = scene::inverseOrZero(scene.view().projection(draw.projection, aspect)) * clip;
    Picked picked{draw.place.line, ordinalOf(scene.scene(), draw), draw.word, {}, {}};
    if (eye.w == 0) return picked;
    picked.eye = glm::dvec3(eye) / eye.w;
    picked.point = glm::dvec3(scene::inverseOrZero(scene.view().modelView(draw)) * glm::dvec4(picked.eye, 1));
    return picked;
}

}  // namespace glibra::view
