// Pictures of scenes whose shaders may not end: another process draws them.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "view/session/session.h"

namespace glibra::view {
namespace {

/// A frame that takes longer is slow, in seconds.
constexpr double kSlow = .3;
/// After the other process has not managed it.
constexpr int kNeverSlow = -1'000'000;

}  // namespace

void Session::setTexts(std::map<std::filesystem::path, std::string> texts) {
    options_.texts = std::move(texts);
    drawLimit_ = kUsualDrawLimit;
}

void Session::drawLonger() {
    const bool wasLate = std::ranges::find(diagnostics_, "view-E05", &Diagnostic::id) != diagnostics_.end();
    if (wasLate) drawLimit_ = kLongDrawLimit;
}

const std::vector<Place>& Session::openLoops() {
    if (!openLoops_) openLoops_ = live_->openLoops();
    return *openLoops_;
}

DrawnState Session::drawnState() const {
    DrawnState state;
    state.scene = path_;
    state.loading = timesLoaded_;
    state.options = loadOptions();
    state.knobs = knobs_;
    state.view = shownView();
    state.camera = camera_;
    state.time = clock_.time();
    state.axes = axes_;
    state.wireframe = wireframe_;
    state.mouseX = mouse_.x;
    state.mouseY = mouse_.y;
    state.isMouseDown = mouse_.isDown;
    state.width = width_;
    state.height = height_;
    state.samples = samples_;
    state.watchesLoops = watchesLoops_;
    return state;
}

/// Makes the received picture what picture() gives.
bool Session::showReceived(const DrawingOrder& order) {
    const gpu::Texels texels{process_.pixels(), 4, gpu::TexelType::u8};
    if (received_ && target_ && target_->width() == order.width && target_->height() == order.height) {
        append(diagnostics_, received_->upload(0, texels));
        return true;
    }
    Result<gpu::Texture> made =
        gpu::Texture::create(context_.capabilities(), gpu::TextureShape::texture2D, gpu::TexelFormat::rgba8,
                             {order.width, order.height, 1}, texels);
    if (!made) {
        append(diagnostics_, std::move(made.diagnostics));
        return false;
    }
    target_.reset();
    received_ = std::move(made.value);
    const std::array<const gpu::Texture*, 1> textures{&*received_};
    Result<gpu::Target> target = gpu::Target::textures(context_.capabilities(), textures);
    append(diagnostics_, std::move(target.diagnostics));
    target_ = std::move(target.value);
    return target_.has_value();
}

void Session::stopOpenLoops(DrawingProcess::State why) {
    isStopped_ = true;
    for (const Place& each : openLoops())
        diagnostics_.push_back(diagnose(
            "view-E05",
            why == DrawingProcess::State::late
                ? fmt::format("this loop may not end: drawing was stopped after {:g} seconds; change a value "
                              "or the text, or press F5 to draw for up to {:g} seconds",
                              drawLimit_, kLongDrawLimit)
                : std::string("this loop may not end: the process that drew it has ended unexpectedly; "
                              "change a value or the text, or press F5 to draw it again"),
            each));
}

void Session::noteDrawn(double seconds) {
    if (slowFrames_ >= kMostSlowFrames) return;
    const bool isSlow = seconds > kSlow && isMoving();
    slowFrames_ = isSlow ? slowFrames_ + 1 : std::min(slowFrames_, 0);
}

/// Has the other process draw the frame, if the scene is one for it. `tried`: it has done so, and this
/// process may draw the same frame.
Session::Elsewhere Session::drawElsewhere() {
    const bool isOpen = isContained_ && !openLoops().empty();
    if (!isOpen && (!isContained_ || slowFrames_ < kMostSlowFrames)) return Elsewhere::no;
    Diagnostics found;
    const ViewState view = shownView();
    if (live_->look(width_, height_, view, clock_.time(), found)) debugRenderer_.reset();
    append(diagnostics_, std::move(found));
    const bool isSoftware = context_.capabilities().isSoftware;
    const scene::Scene& scene = live_->scene();
    const bool isShown = isSoftware && !drawsItself_ && debugView_ == DebugView::picture &&
                         !measuresObjects_ && scene.once.empty() && scene.steps.empty();
    if (!isOpen && !isShown) return Elsewhere::no;
    DrawnState state = drawnState();
    if (!isSoftware) {
        // A driver ends a draw that takes too long by itself. New shaders and values are tried here first.
        state.view = {};
        state.time = state.mouseX = state.mouseY = 0;
        state.isMouseDown = false;
        state.width = state.height = 64;
        state.samples = 1;
    }
    drawnShrinking_ = shrinking();
    const DrawingOrder order{orderText(state), state.width,   state.height,
                             state.time,       state.loading, watchesLoops_};
    if (!isShown && order.text == tried_) return Elsewhere::tried;
    // What is only slow ends by itself.
    constexpr double kNoLimit = 1e9;
    const DrawingProcess::State answer = process_.draw(order, isOpen ? drawLimit_ : kNoLimit);
    switch (answer) {
        case DrawingProcess::State::working:
            return Elsewhere::waits;
        case DrawingProcess::State::late:
        case DrawingProcess::State::ended:
            if (process_.order().watchesLoops) {  // without that it was fast enough
                watchesLoops_ = false;
                return Elsewhere::waits;
            }
            if (!isOpen) {
                slowFrames_ = kNeverSlow;
                return Elsewhere::no;
            }
            stopOpenLoops(answer);
            return Elsewhere::waits;
        case DrawingProcess::State::missing:
            isContained_ = false;
            return Elsewhere::no;
        case DrawingProcess::State::drawn:
            break;
    }
    for (const Diagnostic& each : process_.diagnostics())
        if (std::none_of(diagnostics_.begin(), diagnostics_.end(), [&](const Diagnostic& known) {
                return known.id == each.id && known.place == each.place && known.text == each.text;
            }))
            diagnostics_.push_back(each);
    tried_ = process_.order().text;
    if (process_.order().watchesLoops) watchesLoops_ = false;
    if (!isShown) return tried_ == order.text ? Elsewhere::tried : Elsewhere::waits;
    if (!showReceived(process_.order())) {
        isContained_ = false;
        return Elsewhere::no;
    }
    // It has become fast: by an edit, another value, a smaller window.
    if (!isOpen && process_.seconds() < kSlow / 2) slowFrames_ = 0;
    ++framesDrawn_;
    pictureTime_ = process_.order().time;
    isStale_ = process_.order() != order;
    return isStale_ ? Elsewhere::waits : Elsewhere::shown;
}

}  // namespace glibra::view
