// What tools ask a session about the frame that was drawn last.

#include <glad/gl.h>

#include <utility>

#include "view/session/session.h"

namespace glibra::view {

bool Session::canLookInto() {
    drawIfNeeded();
    return live_ && target_ && !isWaiting_ && !isStopped_;
}

ProbedPixel Session::probeDraw(scene::StepIndex step, int x, int row) {
    if (!canLookInto() || step.pass >= live_->scene().frame.passes.size()) return {};
    ProbedPixel pixel =
        view::probeDraw(context_, *live_, step, target_->width(), target_->height(), clock_.time(), x, row);
    if (debugRenderer_) debugRenderer_->forgetPlan();
    return pixel;
}

void Session::tryState(const scene::Draw& draw, const base::RasterState& state) {
    if (!live_) return;
    const auto known = triedStates_.find(draw.id);
    const bool isTried = known != triedStates_.end() && known->second.wanted == draw.raster;
    const base::RasterState ofScene = isTried ? known->second.ofScene : draw.raster;
    if (state == ofScene)
        triedStates_.erase(draw.id);
    else
        triedStates_.insert_or_assign(draw.id, TriedState{draw.word, ofScene, state});
    live_->tryStates(triedStates_);
    if (debugRenderer_) debugRenderer_->forgetPlan();
    isStale_ = true;
}

void Session::endTrials() {
    if (triedStates_.empty() || !live_) return;
    triedStates_.clear();
    live_->tryStates({});
    if (debugRenderer_) debugRenderer_->forgetPlan();
    isStale_ = true;
}

std::string Session::numbersOfPass(std::size_t pass, DebugView kind, TexelImage& numbers) {
    if (!canLookInto() || pass >= live_->scene().frame.passes.size()) return "no frame has been drawn";
    // Not that of the picture, whose numbers stay.
    DebugRenderer renderer(context_, *live_);
    std::string problem =
        renderer.drawPass(pass, target_->width(), target_->height(),
                          {.kind = kind, .normalLength = normalLength_, .time = clock_.time()});
    numbers = renderer.numbers();
    return problem;
}

void Session::keepBefore() {
    if (!target_ || framesDrawn_ == 0) return;
    const int width = target_->width(), height = target_->height();
    if (!before_ || before_->width() != width || before_->height() != height) {
        before_.reset();
        Result<gpu::Target> made =
            gpu::Target::window(context_.capabilities(), width, height, gpu::TexelFormat::rgba8);
        if (!made) return;
        before_ = std::move(made.value);
    }
    target_->readable().bindForReading();
    before_->bind();
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace glibra::view
