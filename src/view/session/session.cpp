#include "view/session/session.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/files.h"
#include "glib/text.h"
#include "image/file.h"

namespace glibra::view {

Session::Session(gpu::Context& context, RenderOptions options)
    : context_(context), options_(std::move(options)) {}

/// The scene's text with the files that the user has chosen. Nothing if there are none, or if the scene
/// cannot be read.
std::optional<std::string> Session::textWithFiles() const {
    const auto bytes = image::readFile(path_, {path_.generic_string(), {}});
    if (!bytes) return std::nullopt;
    return withFiles(base::asText(*bytes), chosenFiles_);
}

RenderOptions Session::loadOptions() const {
    RenderOptions options = options_;
    if (!isVerbose_ && chosenFiles_.empty()) return options;
    options.sceneText = textWithFiles();
    // The first of the two line feeds ends a last line that is continued.
    if (options.sceneText && isVerbose_) *options.sceneText += "\n\nVerbose\n";
    return options;
}

std::string Session::chooseFile(const Place& place, const std::filesystem::path& file) {
    const auto bytes = image::readFile(path_, {path_.generic_string(), {}});
    if (!bytes) return toString(bytes.diagnostics.front());
    auto chosen = chosenFile(base::asText(*bytes), place, file);
    if (!chosen) return "the scene has changed meanwhile; choose the file again";
    if (chosen->name.find('"') != std::string::npos)
        return "a scene cannot name a file with a quotation mark in its name: " + chosen->name;
    chosenFiles_.push_back(std::move(*chosen));
    return {};
}

bool Session::open(const std::filesystem::path& path) {
    options_.texts.clear();
    render::LiveScene::Loading loading = render::LiveScene::load(context_, path, options_, nullptr);
    if (!loading.scene) {
        diagnostics_ = std::move(loading.diagnostics);
        return false;
    }
    path_ = path;
    process_.end();
    drawLimit_ = kUsualDrawLimit;
    drawsItself_ = false;
    chosenFiles_.clear();
    isVerbose_ = false;
    values_.clear();
    clearPick();
    look_.begin(loading.scene->scene());
    clock_.setState({});
    trials_.clear();
    before_.reset();
    showsBefore_ = false;
    isOfFiles_ = true;
    take(std::move(loading), false);
    return true;
}

bool Session::reload() {
    if (path_.empty()) return false;
    render::LiveScene::Loading loading = render::LiveScene::load(context_, path_, loadOptions(), live_.get());
    if (!loading.scene) {
        diagnostics_ = std::move(loading.diagnostics);
        if (!loading.isPreviousLost) return false;
        debugRenderer_.reset();
        values_.clear();
        look_.leave();
        clearPick();
        isWaiting_ = false;
        live_.reset();
        return false;
    }
    if (isOfFiles_) keepBefore();
    isOfFiles_ = options_.texts.empty();
    take(std::move(loading), true);
    return true;
}

void Session::releaseDevice() {
    values_.leave();
    look_.leave();
    debugRenderer_.reset();
    objectTimer_.reset();
    live_.reset();
    target_.reset();
    received_.reset();
    process_.end();
    plain_.reset();
    before_.reset();
    showsBefore_ = false;
}

void Session::restoreDevice() {
    const bool wasStopped = isStopped_;
    Diagnostics before = diagnostics_;
    if (!reload() || !wasStopped) return;
    isStopped_ = true;
    std::erase_if(before,
                  [](const Diagnostic& each) { return each.id != "view-E04" && each.id != "view-E05"; });
    append(diagnostics_, std::move(before));
}

void Session::stop(const base::DeviceLost& lost) {
    if (path_.empty()) return;
    isStopped_ = true;
    diagnostics_.push_back(
        diagnose("view-E04",
                 "stopped, because the graphics driver reset the device" + base::whileDrawn(lost) +
                     "; change a value or the text, or reload the scene, to draw it again",
                 lost.place.file.empty() ? Place{path_.generic_string(), 1, 1} : lost.place));
}

void Session::take(render::LiveScene::Loading loading, bool sameScene) {
    values_.leave();
    look_.leave(sameScene ? &loading.scene->scene() : nullptr);
    isStopped_ = isWaiting_ = showsBefore_ = watchesLoops_ = false;
    isUnwatched_ = true;
    // What was slow before an edit is tried by the other process first.
    if (!sameScene || slowFrames_ < kMostSlowFrames) slowFrames_ = 0;
    openLoops_.reset();
    debugRenderer_.reset();
    if (objectTimer_) objectTimer_->forget();
    live_ = std::move(loading.scene);
    diagnostics_ = std::move(loading.diagnostics);
    values_.enter(live_->scene(), live_->knobs());
    if (!trials_.empty()) {
        trials_.follow(live_->scene(), [this](const std::filesystem::path& file) { return readText(file); });
        live_->tryStates(trials_.states());
    }
    live_->setMouse(mouse_.x, mouse_.y, mouse_.isDown);
    look_.enter(*live_);
    isStale_ = true;
    ++timesLoaded_;
}

/// A value has changed.
void Session::apply(const render::Knob& knob) {
    live_->setValue(knob);
    isStopped_ = watchesLoops_ = false;
    isUnwatched_ = true;
    openLoops_.reset();
    std::erase_if(diagnostics_, [](const Diagnostic& each) {
        return each.id == "draw-W08" || each.id == "view-E04" || each.id == "view-E05";
    });
    append(diagnostics_, live_->longLoops());
    isStale_ = true;
}

bool Session::pressKey(std::string_view key) {
    if (!live_) return false;
    bool isBound = false;
    const std::vector<scene::KeyBinding> bindings = live_->scene().keys;
    for (const scene::KeyBinding& each : bindings) {
        if (!glib::sameWord(each.key, key)) continue;
        isBound = true;
        if (each.restarts) restart();
        if (!each.isHeld) values_.press(each);
    }
    return isBound;
}

void Session::holdKey(std::string_view key, double seconds) {
    if (!live_) return;
    const std::vector<scene::KeyBinding> bindings = live_->scene().keys;
    for (const scene::KeyBinding& each : bindings)
        if (each.isHeld && glib::sameWord(each.key, key)) values_.hold(each, seconds);
}

void Session::setMouse(double x, double y, bool isDown) {
    const DrawnState::Mouse mouse{x, y, isDown};
    if (mouse == mouse_) return;
    mouse_ = mouse;
    if (!live_) return;
    live_->setMouse(x, y, isDown);
    isStale_ = isStale_ || live_->readsMouse();
}

void Session::showLike(const Session& other) {
    setSamples(other.samples_);
    clock_.setTime(other.pictureTime_);
    values_.setLike(other.values_);
    look_.setLike(other.look_, path_ == other.path_);
    setMouse(other.mouse_.x, other.mouse_.y, other.mouse_.isDown);
}

void Session::restart() {
    clock_.setTime(0);
    if (live_) live_->restart();
    isStale_ = true;
}

void Session::nextStep() {
    if (!live_) return;
    double next = std::numeric_limits<double>::infinity();
    for (const render::Simulation::Progress& each : live_->steps())
        next =
            std::min(next, (static_cast<double>(render::stepsAt(clock_.time(), each.rate)) + 1) / each.rate);
    clock_.pauseAt(next);
}

/// The clock shows another time.
void Session::followClock() {
    isStale_ = isStale_ || (live_ && live_->isAnimated());
    values_.followClock();
}

void Session::advance(double seconds) {
    if (!isStopped_ && usesTime()) clock_.advance(seconds);
}

bool Session::isMoving() const {
    return !isStopped_ && clock_.isPlaying() && clock_.speed() != 0 && usesTime();
}

RenderOptions Session::renderOptions(int width, int height) const {
    RenderOptions options = options_;
    options.texts.clear();
    options.width = width > 0 ? width : look_.width();
    options.height = height > 0 ? height : look_.height();
    options.time = clock_.time();
    options.axes = look_.axes();
    options.labels = look_.labels();
    if (!chosenFiles_.empty()) options.sceneText = textWithFiles();
    options.viewState = look_.shownView();
    for (const render::Knob& each : values_.knobs())
        if (each.isChanged()) options.set.push_back(setArgument(live_->scene(), each, values_.knobs()));
    return options;
}

std::string Session::onlyOnScreen() const {
    std::string words;
    const auto add = [&](const std::string& word) { words += (words.empty() ? "" : " and ") + word; };
    if (look_.wireframe()) add("wireframe");
    if (!trials_.states().empty()) add("states of draws that are tried");
    if (look_.debugView() != DebugView::picture)
        add("the debug view '" + std::string(nameOf(look_.debugView())) + "'");
    if (!look_.camera().empty()) add("the camera '" + look_.camera() + "'");
    if (live_ && live_->readsMouse() && mouse_ != DrawnState::Mouse{}) add("the mouse");
    if (!options_.texts.empty()) add("text that is not saved");
    return words;
}

}  // namespace glibra::view
