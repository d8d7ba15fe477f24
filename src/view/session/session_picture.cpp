// The picture of a session: when it is drawn, and what tools find in it.

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "base/files.h"
#include "image/file.h"
#include "view/edit/source_lines.h"
#include "view/scene/window_target.h"
#include "view/session/session.h"

namespace glibra::view {
namespace {

/// The number that DrawId::file has for the file now; `known` if it draws nothing.
int fileNumber(const scene::Scene& scene, const std::filesystem::path& file, int known) {
    for (const scene::Pass& pass : scene.frame.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<scene::Draw>(&step);
                draw != nullptr && draw->place.file == file)
                return draw->id.file;
    return known;
}

constexpr std::size_t kMostDiagnostics = 200;

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

const TexelImage& Session::debugNumbers() const {
    static const TexelImage kNoNumbers;
    return debugRenderer_ && look_.debugView() != DebugView::picture ? debugRenderer_->numbers() : kNoNumbers;
}

void Session::setSamples(int samples) {
    samples = std::clamp(samples, 1, context_.capabilities().maxSamples);
    if (samples == samples_) return;
    samples_ = samples;
    hasOtherSamples_ = true;  // the last picture stays until there is another one
    isStale_ = true;
}

Diagnostics Session::drawShown() {
    const ViewState& shown = look_.beginFrame();
    Diagnostics diagnostics;
    if (look_.debugView() == DebugView::picture) {
        if (!measuresObjects_) return live_->draw(*target_, shown, clock_.time(), look_.axes());
        // Before the drawer is used.
        live_->moveTo(look_.width(), look_.height(), clock_.time(), diagnostics);
        if (!objectTimer_) objectTimer_.emplace(context_.capabilities());
        if (!isMoving()) objectTimer_->forget();  // single frames have nothing in common
        objectTimer_->begin(live_->drawer(), live_->plan());
        append(diagnostics, live_->draw(*target_, shown, clock_.time(), look_.axes()));
        objectTimer_->end(live_->drawer());
        // No later frame would tell it; where frames move, nothing waits.
        if (!isMoving()) objectTimer_->finish();
        return diagnostics;
    }
    objectTimer_.reset();
    if (live_->moveTo(look_.width(), look_.height(), clock_.time(), diagnostics)) debugRenderer_.reset();
    if (!debugRenderer_) debugRenderer_.emplace(context_, *live_);
    append(diagnostics,
           debugRenderer_->draw(*target_, shown,
                                {look_.debugView(), look_.normalLength(), clock_.time(), look_.axes()}));
    return diagnostics;
}

/// Returns false if there is no memory for it.
bool Session::makeTarget(std::optional<gpu::Target>& target, int samples) {
    append(diagnostics_, fit(target, context_.capabilities(), live_->scene(), look_.width(), look_.height(),
                             gpu::TexelFormat::rgba8, samples));
    return target.has_value();
}

bool Session::watchLoops() {
    const bool isFree = live_ && target_ && !isStale_ && !isStopped_ && !measuresObjects_ &&
                        !values_.isAnyAnimated() && look_.debugView() == DebugView::picture;
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
    const bool isMixed = look_.debugView() == DebugView::picture || look_.debugView() == DebugView::normals;
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
    if (plain_ && plainFrame_ == framesDrawn_ && plain_->width() == look_.width() &&
        plain_->height() == look_.height())
        return &*plain_;
    if (!makeTarget(plain_, 1)) return nullptr;
    for (Diagnostic& each : live_->draw(*plain_, look_.shownView(), clock_.time(), look_.axes()))
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
        look_.setPicked(pick(*live_, *plain, clock_.time(), x, y));
    plainFrame_ = 0;
    // Picking draws the pixel without the debug view.
    if (look_.debugView() != DebugView::picture) isStale_ = true;
}

/// Picks what was pointed at while another process drew the picture.
void Session::pickWaiting() {
    if (const auto waiting = std::exchange(pickLater_, std::nullopt)) pickAt((*waiting)[0], (*waiting)[1]);
}

ProbedPixel Session::probe(int x, int y) {
    if (!canLookInto()) {
        ProbedPixel none;
        none.x = x;
        none.y = y;
        none.height = look_.height();
        return none;
    }
    ProbedPixel pixel =
        probePixel(context_, *live_, target_->width(), target_->height(), clock_.time(), x, y);
    if (debugRenderer_) debugRenderer_->forgetPlan();
    return pixel;
}

void Session::clearPick() {
    pickLater_.reset();
    look_.setPicked({});
}

// What tools ask a session about the frame that was drawn last.

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

std::string Session::numbersOfPass(std::size_t pass, DebugView kind, TexelImage& numbers, int layer) {
    if (!canLookInto() || pass >= live_->scene().frame.passes.size()) return "no frame has been drawn";
    // Not that of the picture, whose numbers stay.
    DebugRenderer renderer(context_, *live_);
    std::string problem = renderer.drawPass(
        pass, target_->width(), target_->height(),
        {.kind = kind, .normalLength = look_.normalLength(), .time = clock_.time(), .layer = layer});
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
    if (showsBefore_ && usesTime() && live_->scene().steps.empty()) clock_.pauseAt(beforeTime_);
}

void Trials::list() {
    states_.clear();
    for (const Trial& each : trials_)
        if (each.now.line > 0) states_.emplace(each.now, each.state);
}

/// From now on draws are followed from where they are now. Those that are gone do not come back.
void Trials::keepTexts(const TextOf& textOf) {
    std::erase_if(trials_, [](const Trial& each) { return each.now.line == 0; });
    texts_.clear();
    for (Trial& each : trials_) {
        each.then = each.now;
        if (!texts_.contains(each.file)) texts_.emplace(each.file, textOf(each.file));
    }
}

void Trials::set(const scene::Draw& draw, const base::RasterState& state, const TextOf& textOf) {
    const auto known = std::ranges::find(trials_, draw.id, &Trial::now);
    // A trial has ended if the scene gives its draw another state than it did.
    const bool isTried = known != trials_.end() && known->state.wanted == *draw.raster;
    const base::RasterState ofScene = isTried ? known->state.ofScene : *draw.raster;
    if (known != trials_.end()) trials_.erase(known);
    if (state != ofScene)
        trials_.push_back({draw.place.file, draw.id, draw.id, render::TriedState{draw.word, ofScene, state}});
    keepTexts(textOf);
    list();
}

void Trials::follow(const scene::Scene& scene, const TextOf& textOf) {
    std::map<std::filesystem::path, std::string> now;
    bool isAnyGone = false;
    for (Trial& each : trials_) {
        if (!now.contains(each.file)) now.emplace(each.file, textOf(each.file));
        each.now = each.then;
        each.now.line = movedLine(texts_[each.file], now[each.file], each.then.line);
        each.now.file = fileNumber(scene, each.file, each.then.file);
        isAnyGone = isAnyGone || each.now.line == 0;
    }
    // While a line is edited, it may not be a statement for a while.
    if (!isAnyGone) {
        texts_ = std::move(now);
        for (Trial& each : trials_) each.then = each.now;
    }
    list();
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

DrawnState Session::beginDrawnState() {
    return {.scene = path_,
            .loading = timesLoaded_,
            .options = loadOptions(),
            .knobs = values_.knobs(),
            .view = look_.beginFrame(),
            .camera = look_.camera(),
            .time = clock_.time(),
            .axes = look_.axes(),
            .wireframe = look_.wireframe(),
            .mouse = mouse_,
            .watchesLoops = watchesLoops_,
            .width = look_.width(),
            .height = look_.height(),
            .samples = samples_};
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
    const ViewState view = look_.shownView();
    if (live_->look(look_.width(), look_.height(), view, clock_.time(), found)) debugRenderer_.reset();
    append(diagnostics_, std::move(found));
    const bool isSoftware = context_.capabilities().isSoftware;
    const scene::Scene& scene = live_->scene();
    const bool isShown = isSoftware && !drawsItself_ && look_.debugView() == DebugView::picture &&
                         !measuresObjects_ && scene.once.empty() && scene.steps.empty();
    if (!isOpen && !isShown) return Elsewhere::no;
    DrawnState state = beginDrawnState();
    if (!isSoftware) {
        // A driver ends a draw that takes too long by itself. New shaders and values are tried here first.
        state.view = {};
        state.time = 0;
        state.mouse = {0, 0, false};
        state.width = state.height = 64;
        state.samples = 1;
    }
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
