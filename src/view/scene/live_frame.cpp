// Draws a frame of a live scene: only what differs from the frame before.

#include <set>
#include <utility>

#include "plan/accesses.h"
#include "plan/still.h"
#include "scene/view.h"
#include "view/scene/live_state.h"

namespace glibra::view {

/// Keeps what was drawn, for comparison with the next frame. Call it before the values in `plan` change, or
/// before `scene` and `plan` (`ofScene`) are replaced.
void LiveScene::State::noteChange(bool ofScene) {
    if (!isDrawn || !scene.isModern || (drawnBefore && (!ofScene || drawnBefore->scene))) return;
    if (!ofScene) {
        drawnBefore = Drawn{{}, plan};
        return;
    }
    if (!drawnBefore) drawnBefore = Drawn{{}, std::move(plan)};
    drawnBefore->scene = std::move(scene);
    drawnBefore->plan.nodes = &drawnBefore->scene->frame;
}

/// What of the frame is the same as in the frame before. A pass that the window's transforms move is the same
/// only while they stay.
plan::StillNodes LiveScene::State::stillNodes(int width, int height) const {
    const ViewState& now = view.state();
    const bool isComparable = isDrawn && scene.isModern && drawer->drawsPlainly() && width == drawnWidth &&
                              height == drawnHeight && now.projection == ProjectionMode::scene &&
                              drawnView.projection == ProjectionMode::scene &&
                              now.objects == drawnView.objects && now.texture == drawnView.texture;
    if (!isComparable) return {};
    std::set<plan::Object> moved;
    std::vector<bool> isMovedNode(plan.order.size());
    if (now.scene != drawnView.scene || now.eye != drawnView.eye)
        for (std::size_t node = 0; node < plan.order.size(); ++node) {
            const scene::NodeIndex& at = plan.order[node];
            if (at.kind != scene::NodeIndex::Kind::pass) continue;
            const scene::Pass& pass = plan.passOf(plan.passes[at.index]);
            isMovedNode[node] = !pass.isWindow && render::isMoved(*plan.nodes, pass);
            if (!isMovedNode[node]) continue;
            for (const plan::ObjectUse& each : plan::usesOf(plan, node))
                if (each.writes) moved.insert(plan::objectOf(each.object));
        }
    const bool hasRun = simulation && simulation->changes() != drawnChanges;
    const plan::PlannedScene before =
        drawnBefore ? plan::PlannedScene{drawnBefore->scene ? *drawnBefore->scene : scene, drawnBefore->plan}
                    : plan::PlannedScene{scene, plan};
    plan::StillNodes still = plan::stillNodes(before, {scene, plan}, [&](const plan::Object& each) {
        return moved.contains(each) || (hasRun && simulation->lasts(each));
    });
    for (std::size_t node = 0; node < still.nodes.size(); ++node)
        if (isMovedNode[node]) still.nodes[node] = false;
    for (const plan::Object& each : moved) still.contents.erase(each);
    return still;
}

Diagnostics LiveScene::State::drawFrame(const gpu::Target& target, double time) {
    const int width = target.width(), height = target.height();
    samples = target.samples();
    drawer->cullToTile(drawsOutOfSight ? 0 : samples);
    const plan::StillNodes still = stillNodes(width, height);
    Diagnostics diagnostics =
        drawer->draw(target, {view, width, height, {0, 0, width, height}, time, true, &still});
    drawnBefore.reset();
    isDrawn = scene.isModern && drawer->drawsPlainly() && !hasError(diagnostics);
    if (!isDrawn) return diagnostics;
    drawnView = view.state();
    drawnWidth = width;
    drawnHeight = height;
    drawnChanges = simulation ? simulation->changes() : 0;
    return diagnostics;
}

void LiveScene::State::placeEye(double aspect, Diagnostics& diagnostics) {
    if (eyeAspect == aspect) return;
    eyeAspect = aspect;
    eyeDistance = 0;
    if (options.view == ViewPolicy::glman || scene.usesLookAt) return;
    scene::ViewMove move = scene::autoView(
        scene, [&](scene::ShapeIndex shape) { return device.mesh(shape, false, &diagnostics); }, aspect);
    eyeDistance = move.distance;
    append(diagnostics, std::move(move.diagnostics));
}

Diagnostics LiveScene::draw(const gpu::Target& target, const ViewState& view, double time, bool axes) {
    State& state = *state_;
    Diagnostics diagnostics;
    moveTo(target.width(), target.height(), time, diagnostics);
    const double aspect = static_cast<double>(target.width()) / target.height();
    state.placeEye(aspect, diagnostics);
    // Setting a view copies the transforms of objects, which allocates memory. An unchanged view is not set
    // again.
    if (!state.isViewSet || view != state.view.state() || state.setEyeDistance != state.eyeDistance) {
        state.view = render::ViewMatrices(view, state.scene.view, state.eyeDistance);
        state.setEyeDistance = state.eyeDistance;
        state.isViewSet = true;
    }
    const render::Tile whole{0, 0, target.width(), target.height()};
    if (state.simulation && !state.isSimulationWrong) {
        state.inputs.time = time;
        append(diagnostics, state.simulation->advance(state.inputs));
    }
    append(diagnostics, state.drawFrame(target, time));
    if (axes && !state.axes) {
        Result<render::Axes> made = render::Axes::create(state.context);
        append(diagnostics, std::move(made.diagnostics));
        state.axes = std::move(made.value);
    }
    if (axes && state.axes)
        state.axes->draw(target, state.scene, state.view, whole, target.width(), target.height());
    target.resolve();
    append(diagnostics, state.context.debugLog().takeDiagnostics());
    return diagnostics;
}

}  // namespace glibra::view
