// The picture of a session: its size, when it is drawn, and what is found in it.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "view/scene/window_target.h"
#include "view/session/session.h"

namespace glibra::view {
namespace {

constexpr std::size_t kMostDiagnostics = 200;
constexpr int kLargestSide = 16384;

/// A note about the same place replaces the earlier one, whose numbers were for another picture size.
void addOnce(Diagnostics& diagnostics, Diagnostic added) {
    for (Diagnostic& known : diagnostics) {
        if (known.id != added.id || known.place != added.place) continue;
        const bool isNote = known.severity == Severity::note && added.severity == Severity::note;
        if (isNote) known.text = added.text;
        if (known.text == added.text) return;
    }
    if (diagnostics.size() < kMostDiagnostics) diagnostics.push_back(std::move(added));
}

// Pictures of scenes whose shaders may not end: another process draws them.

/// A frame that takes longer is slow, in seconds.
constexpr double kSlow = .3;
/// After the other process has not managed it.
constexpr int kNeverSlow = -1'000'000;

}  // namespace

void Session::setMeasuresObjects(bool on) {
    if (on == measuresObjects_) return;
    measuresObjects_ = on;
    objectTimer_.reset();
    isStale_ = isStale_ || on;
}

void Session::keepTextures() {
    if (!live_) return;
    isStale_ = isStale_ || (!drawsItself_ && received_);
    drawsItself_ = true;
    Diagnostics diagnostics;
    if (live_->keepTextures(diagnostics)) {
        debugRenderer_.reset();
        isStale_ = true;
    }
    for (Diagnostic& each : diagnostics) addOnce(diagnostics_, std::move(each));
}

void Session::setAxes(bool on) {
    if (std::exchange(axes_, on) != on) isStale_ = true;
}

void Session::setWireframe(bool on) {
    if (std::exchange(wireframe_, on) != on) isStale_ = true;
    if (live_) live_->drawer().setWireframe(on);
}

void Session::setDebugView(DebugView kind) {
    if (std::exchange(debugView_, kind) != kind) isStale_ = true;
}

void Session::setNormalLength(double length) {
    constexpr double kShortest = .005;
    if (!(length > 0)) return;
    length = std::clamp(length, kShortest, 1.0);
    isStale_ = isStale_ || (length != normalLength_ && debugView_ == DebugView::normals);
    normalLength_ = length;
}

const TexelImage& Session::debugNumbers() const {
    static const TexelImage kNoNumbers;
    return debugRenderer_ && debugView_ != DebugView::picture ? debugRenderer_->numbers() : kNoNumbers;
}

void Session::resize(int width, int height) {
    width = std::clamp(width, 1, kLargestSide);
    height = std::clamp(height, 1, kLargestSide);
    isStale_ = isStale_ || width != width_ || height != height_;
    width_ = width;
    height_ = height;
}

void Session::setSamples(int samples) {
    samples = std::clamp(samples, 1, context_.capabilities().maxSamples);
    if (samples == samples_) return;
    samples_ = samples;
    hasOtherSamples_ = true;  // the last picture stays until there is another one
    isStale_ = true;
}

void Session::setWholeShape(double aspect) {
    wholeShape_ = aspect;
    // How far the eye is moved back, on which this depends too, is known only after a frame.
    isStale_ = isStale_ || shrinking() != drawnShrinking_;
}

Diagnostics Session::drawShown() {
    drawnShrinking_ = shrinking();
    // Frames of a moving scene allocate no memory, so the view is copied only if it differs.
    std::optional<ViewState> smaller;
    const ViewState& shown = drawnShrinking_ == 1 ? view_ : smaller.emplace(shownView());
    Diagnostics diagnostics;
    if (debugView_ == DebugView::picture) {
        if (!measuresObjects_) return live_->draw(*target_, shown, clock_.time(), axes_);
        live_->moveTo(width_, height_, clock_.time(), diagnostics);  // before the drawer is used
        if (!objectTimer_) objectTimer_.emplace(context_.capabilities());
        if (!isMoving()) objectTimer_->forget();  // single frames have nothing in common
        objectTimer_->begin(live_->drawer(), live_->plan());
        append(diagnostics, live_->draw(*target_, shown, clock_.time(), axes_));
        objectTimer_->end(live_->drawer());
        // No later frame would tell it; where frames move, nothing waits.
        if (!isMoving()) objectTimer_->finish();
        return diagnostics;
    }
    objectTimer_.reset();
    if (live_->moveTo(width_, height_, clock_.time(), diagnostics)) debugRenderer_.reset();
    if (!debugRenderer_) debugRenderer_.emplace(context_, *live_);
    append(diagnostics,
           debugRenderer_->draw(*target_, shown, {debugView_, normalLength_, clock_.time(), axes_}));
    return diagnostics;
}

/// Returns false if there is no memory for it.
bool Session::makeTarget(std::optional<gpu::Target>& target, int samples) {
    append(diagnostics_, fit(target, context_.capabilities(), live_->scene(), width_, height_,
                             gpu::TexelFormat::rgba8, samples));
    return target.has_value();
}

bool Session::watchLoops() {
    const bool isFree = live_ && target_ && !isStale_ && !isStopped_ && !measuresObjects_ &&
                        animations_.empty() && debugView_ == DebugView::picture;
    if (!isFree || !std::exchange(isUnwatched_, false) || !live_->hasLoopsToWatch()) return false;
    watchesLoops_ = isStale_ = true;
    return true;
}

bool Session::drawIfNeeded() {
    if (!isStale_ || !live_ || isStopped_) return false;
    const Elsewhere elsewhere = drawElsewhere();
    isWaiting_ = elsewhere == Elsewhere::waits && !isStopped_;
    if (elsewhere == Elsewhere::waits) return false;
    if (elsewhere == Elsewhere::shown) {
        pickWaiting();
        return true;
    }
    if (std::exchange(hasOtherSamples_, false) || received_) target_.reset();
    received_.reset();
    if (std::exchange(watchesLoops_, false)) live_->watchLoops();
    // Debug views show numbers, which must not be mixed.
    const bool isMixed = debugView_ == DebugView::picture || debugView_ == DebugView::normals;
    if (!makeTarget(target_, isMixed ? samples_ : 1)) {
        isStale_ = false;
        return false;
    }
    for (Diagnostic& each : drawShown()) addOnce(diagnostics_, std::move(each));
    isStale_ = false;
    pictureTime_ = clock_.time();
    ++framesDrawn_;
    pickWaiting();
    return true;
}

const gpu::Target* Session::plainPicture() {
    if (!live_ || !target_ || (target_->samples() == 1 && !received_)) return picture();
    if (isWaiting_ || isStopped_) return nullptr;
    if (plain_ && plainFrame_ == framesDrawn_ && plain_->width() == width_ && plain_->height() == height_)
        return &*plain_;
    if (!makeTarget(plain_, 1)) return nullptr;
    for (Diagnostic& each : live_->draw(*plain_, shownView(), clock_.time(), axes_))
        addOnce(diagnostics_, std::move(each));
    plainFrame_ = framesDrawn_;
    return &*plain_;
}

void Session::pickAt(int x, int y) {
    drawIfNeeded();
    pickLater_.reset();
    if (isStopped_) return;
    if (isWaiting_) {
        pickLater_ = {x, y};
        return;
    }
    if (const gpu::Target* plain = plainPicture(); live_ && plain)
        picked_ = pick(*live_, *plain, clock_.time(), x, y);
    plainFrame_ = 0;
    // Picking draws the pixel without the debug view.
    if (debugView_ != DebugView::picture) isStale_ = true;
}

/// Picks what was pointed at while another process drew the picture.
void Session::pickWaiting() {
    if (const auto waiting = std::exchange(pickLater_, std::nullopt)) pickAt((*waiting)[0], (*waiting)[1]);
}

ProbedPixel Session::probe(int x, int y) {
    drawIfNeeded();
    if (!live_ || !target_ || isWaiting_ || isStopped_) {
        ProbedPixel none;
        none.x = x;
        none.y = y;
        none.height = height_;
        return none;
    }
    ProbedPixel pixel =
        probePixel(context_, *live_, target_->width(), target_->height(), clock_.time(), x, y);
    if (debugRenderer_) debugRenderer_->forgetPlan();
    return pixel;
}

void Session::clearPick() {
    pickLater_.reset();
    picked_.reset();
}

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
