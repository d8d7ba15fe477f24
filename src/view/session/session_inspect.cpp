// What tools ask a session about the frame that was drawn last.

#include <glad/gl.h>

#include <utility>

#include "base/files.h"
#include "image/file.h"
#include "view/scene/window_target.h"
#include "view/session/session.h"

namespace glibra::view {

bool Session::canLookInto() {
    drawIfNeeded();
    return live_ && target_ && !isWaiting_ && !isStopped_;
}

ProbedPixel Session::probeDraw(scene::StepIndex step, const TargetPixel& at) {
    if (!canLookInto() || step.pass >= live_->scene().frame.passes.size()) return {};
    ProbedPixel pixel =
        view::probeDraw(context_, *live_, step, target_->width(), target_->height(), clock_.time(), at);
    if (debugRenderer_) debugRenderer_->forgetPlan();
    return pixel;
}

std::string Session::readText(const std::filesystem::path& file) const {
    if (const auto typed = options_.texts.find(file); typed != options_.texts.end()) return typed->second;
    const auto bytes = image::readFile(file, {file.generic_string(), {}});
    return bytes ? std::string(base::asText(*bytes)) : std::string();
}

void Session::tryState(const scene::Draw& draw, const base::RasterState& state) {
    if (!live_) return;
    trials_.set(draw, state, [this](const std::filesystem::path& file) { return readText(file); });
    live_->tryStates(trials_.states());
    if (debugRenderer_) debugRenderer_->forgetPlan();
    isStale_ = true;
}

/// The scene has been read again.
void Session::followTrials() {
    if (trials_.empty()) return;
    trials_.follow(live_->scene(), [this](const std::filesystem::path& file) { return readText(file); });
    live_->tryStates(trials_.states());
}

std::string Session::numbersOfPass(std::size_t pass, DebugView kind, TexelImage& numbers, int layer) {
    if (!canLookInto() || pass >= live_->scene().frame.passes.size()) return "no frame has been drawn";
    // Not that of the picture, whose numbers stay.
    DebugRenderer renderer(context_, *live_);
    std::string problem = renderer.drawPass(
        pass, target_->width(), target_->height(),
        {.kind = kind, .normalLength = normalLength_, .time = clock_.time(), .layer = layer});
    numbers = renderer.numbers();
    return problem;
}

void Session::keepBefore() {
    if (!target_ || !live_ || framesDrawn_ == 0) return;
    const int width = target_->width(), height = target_->height();
    fit(before_, context_.capabilities(), live_->scene(), width, height);
    if (!before_) return;
    target_->readable().bindForReading();
    before_->bind();
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    beforeTime_ = pictureTime_;
}

void Session::showBefore(bool on) {
    showsBefore_ = on && before_;
    if (!showsBefore_ || !usesTime() || !live_->scene().steps.empty()) return;
    Clock clock = clock_;
    clock.play(false);
    clock.setTime(beforeTime_);
    setClock(clock);
}

}  // namespace glibra::view
