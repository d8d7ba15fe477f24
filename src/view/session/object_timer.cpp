#include "view/session/object_timer.h"

#include <algorithm>
#include <numeric>

namespace glibra::view {

ObjectTimer::ObjectTimer(const gpu::Capabilities& capabilities)
    : timer_(capabilities, [this](std::size_t frame, double milliseconds) {
          Frame& measured = frames_[frame - first_];
          measured.milliseconds += milliseconds;
          ++measured.known;
      }) {}

void ObjectTimer::beginPiece() {
    if (isInPiece_) return;
    isInPiece_ = true;
    ++frames_.back().begun;
    timer_.begin(first_ + frames_.size() - 1);
}

void ObjectTimer::begin(render::FrameDrawer& drawer, const plan::FramePlan& plan) {
    if (!measures()) return;
    settle();
    frames_.emplace_back();
    isDrawing_ = true;
    drawer.setNodeHook([this, &plan](std::size_t node, bool begins) {
        if (begins && plan.order[node].kind == scene::NodeIndex::Kind::dispatch) return beginPiece();
        if (begins || !isInPiece_) return;
        isInPiece_ = false;
        timer_.end();
    });
    drawer.setDrawHook([this](const plan::PlannedDraw&, bool, bool begins) {
        if (begins) beginPiece();  // after the clears of the pass
    });
}

void ObjectTimer::end(render::FrameDrawer& drawer) {
    if (!isDrawing_) return;
    drawer.setNodeHook({});
    drawer.setDrawHook({});
    isDrawing_ = false;
    settle();
}

void ObjectTimer::finish() {
    timer_.finish();
    settle();
}

/// Takes over what has become known.
void ObjectTimer::settle() {
    timer_.collect();
    while (!frames_.empty() && !isDrawing_ && frames_.front().known == frames_.front().begun) {
        if (!frames_.front().isForgotten) known_[measured_++ % kFrames] = frames_.front().milliseconds;
        frames_.pop_front();
        ++first_;
    }
}

void ObjectTimer::forget() {
    measured_ = 0;
    for (Frame& each : frames_) each.isForgotten = true;
}

std::optional<double> ObjectTimer::milliseconds() const {
    if (measured_ == 0) return std::nullopt;
    const std::size_t count = std::min(measured_, kFrames);
    return std::accumulate(known_.begin(), known_.begin() + static_cast<std::ptrdiff_t>(count), 0.0) /
           static_cast<double>(count);
}

}  // namespace glibra::view
