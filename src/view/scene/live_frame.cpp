// Draws a frame of a live scene: only what differs from the frame before.

#include <utility>

#include "view/scene/live_state.h"

namespace glibra::view {

Diagnostics LiveScene::State::drawFrame(const gpu::Target& target, double time) {
    const int width = target.width(), height = target.height();
    samples = target.samples();
    drawer->cullToTile(drawsOutOfSight ? 0 : samples);
    const plan::StillNodes still = stillNodes(width, height);
    Diagnostics diagnostics =
        drawer->draw(target, {view, width, height, {0, 0, width, height}, time, true, &still});
    noteDrawn(width, height, diagnostics);
    return diagnostics;
}

bool LiveScene::look(int width, int height, const ViewState& view, double time, Diagnostics& diagnostics) {
    State& state = *state_;
    const bool isNew = moveTo(width, height, time, diagnostics);
    state.placeEye(static_cast<double>(width) / height, diagnostics, state.drawStats);
    state.lookFrom(view);
    return isNew;
}

Diagnostics LiveScene::draw(const gpu::Target& target, const ViewState& view, double time, bool axes) {
    State& state = *state_;
    Diagnostics diagnostics;
    look(target.width(), target.height(), view, time, diagnostics);
    const render::Tile whole{0, 0, target.width(), target.height()};
    if (state.simulation && !state.isSimulationWrong) {
        state.inputs.time = time;
        append(diagnostics, state.simulation->advance(state.inputs));
    }
    append(diagnostics, state.drawFrame(target, time));
    if (axes) append(diagnostics, state.makeAxes());
    if (axes && state.axes)
        state.axes->draw(target, state.scene, state.view, whole, target.width(), target.height());
    target.resolve();
    append(diagnostics, state.context.debugLog().takeDiagnostics());
    return diagnostics;
}

}  // namespace glibra::view
