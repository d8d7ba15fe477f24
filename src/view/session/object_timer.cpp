#include "view/session/object_timer.h"

#include <glad/gl.h>

#include <algorithm>
#include <numeric>

namespace glibra::view {

void ObjectTimer::start() {
    if (started_) return;
    glFinish();  // the clears before the first object
    started_ = Clock::now();
}

void ObjectTimer::stop() {
    if (!started_) return;
    glFinish();
    now_ += std::chrono::duration<double, std::milli>(Clock::now() - *started_).count();
    started_.reset();
}

void ObjectTimer::begin(render::FrameDrawer& drawer, const plan::FramePlan& plan) {
    now_ = 0;
    drawer.setNodeHook([this, &plan](std::size_t node, bool begins) {
        if (!begins)
            stop();
        else if (plan.order[node].kind == scene::NodeIndex::Kind::dispatch)
            start();
    });
    drawer.setDrawHook([this](const plan::PlannedDraw&, bool, bool begins) {
        if (begins) start();
    });
}

void ObjectTimer::end(render::FrameDrawer& drawer) {
    drawer.setNodeHook({});
    drawer.setDrawHook({});
    stop();
    frames_[measured_ % kFrames] = now_;
    ++measured_;
}

std::optional<double> ObjectTimer::milliseconds() const {
    if (measured_ == 0) return std::nullopt;
    const std::size_t count = std::min(measured_, kFrames);
    return std::accumulate(frames_.begin(), frames_.begin() + static_cast<std::ptrdiff_t>(count), 0.0) /
           static_cast<double>(count);
}

}  // namespace glibra::view
