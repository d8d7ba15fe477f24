#include "view/session/session.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/files.h"
#include "image/file.h"

namespace glibra::view {
namespace {

/// The transforms of objects after a reload: each goes with the same command at the same place in the order
/// of draws.
std::vector<ViewState::Object> moved(const std::vector<ViewState::Object>& objects, const scene::Scene& from,
                                     const scene::Scene& to) {
    const std::vector<const scene::Draw*> before = windowDraws(from);
    const std::vector<const scene::Draw*> after = windowDraws(to);
    std::vector<ViewState::Object> result;
    for (const ViewState::Object& each : objects)
        for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i)
            if (before[i]->id == each.draw() && before[i]->word == after[i]->word) {
                result.push_back({after[i]->id, each.matrix});
                break;
            }
    return result;
}

}  // namespace

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
    kept_.forget();
    view_ = {};
    camera_.clear();
    clock_ = {};
    animations_.clear();
    trials_.clear();
    width_ = loading.scene->scene().width;
    height_ = loading.scene->scene().height;
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
        if (loading.isPreviousLost) dropScene();
        return false;
    }
    if (isOfFiles_) keepBefore();
    isOfFiles_ = options_.texts.empty();
    take(std::move(loading), true);
    return true;
}

void Session::dropScene() {
    debugRenderer_.reset();
    knobs_.clear();
    animations_.clear();
    clearPick();
    isWaiting_ = false;
    live_.reset();
}

void Session::releaseDevice() {
    if (live_) kept_.keep(live_->scene(), knobs_);
    isReleased_ = isReleased_ || live_;
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
    if (live_) kept_.keep(live_->scene(), knobs_);
    if (sameScene && live_) {
        view_.objects = moved(view_.objects, live_->scene(), loading.scene->scene());
    } else if (!sameScene || !isReleased_) {
        kept_.forget();
    }
    isReleased_ = isStopped_ = isWaiting_ = showsBefore_ = watchesLoops_ = false;
    isUnwatched_ = true;
    // What was slow before an edit is tried by the other process first.
    if (!sameScene || slowFrames_ < kMostSlowFrames) slowFrames_ = 0;
    openLoops_.reset();
    if (picked_) {
        const std::vector<const scene::Draw*> draws = windowDraws(loading.scene->scene());
        const auto ordinal = static_cast<std::size_t>(picked_->ordinal);
        if (sameScene && ordinal < draws.size() && draws[ordinal]->word == picked_->word)
            picked_->draw = draws[ordinal]->id;
        else
            clearPick();
    }
    debugRenderer_.reset();
    if (objectTimer_) objectTimer_->forget();
    live_ = std::move(loading.scene);
    diagnostics_ = std::move(loading.diagnostics);
    const std::vector<render::Knob> before = std::exchange(knobs_, live_->knobs());
    kept_.restore(live_->scene(), knobs_);
    for (Animation& each : animations_) {  // they go with their program, wherever it stands now
        const auto old = std::find_if(before.begin(), before.end(),
                                      [&](const render::Knob& knob) { return each.isOf(knob); });
        if (old == before.end()) continue;
        const auto now = std::find_if(knobs_.begin(), knobs_.end(), [&](const render::Knob& knob) {
            return knob.title == old->title && knob.tag == old->tag;
        });
        const bool isRenamed = std::ranges::any_of(knobs_, [&](const render::Knob& knob) {
            return each.isOf(knob) &&
                   std::ranges::find(before, knob.title, &render::Knob::title) == before.end();
        });
        if (now != knobs_.end())
            each.program = now->program;
        else if (!isRenamed)
            each.tag.clear();  // it ends
    }
    std::erase_if(animations_, [&](const Animation& each) {
        return std::none_of(knobs_.begin(), knobs_.end(), [&](const render::Knob& knob) {
            return each.isOf(knob) && knob.widget == render::Widget::slider &&
                   knob.current.size() == each.phases.size();
        });
    });
    for (std::size_t i = 0; i < knobs_.size(); ++i)
        if (knobs_[i].isChanged()) applyValue(i);
    followTrials();
    live_->drawer().setWireframe(wireframe_);
    live_->setMouse(mouse_.x, mouse_.y, mouse_.isDown);
    setCamera(camera_);
    isStale_ = true;
    ++timesLoaded_;
}

void Session::restart() {
    clock_.setTime(0);
    moveAnimations();
    if (live_) live_->restart();
    isStale_ = true;
}

void Session::nextStep() {
    if (!live_) return;
    double next = std::numeric_limits<double>::infinity();
    for (const render::Simulation::Progress& each : live_->steps())
        next =
            std::min(next, (static_cast<double>(render::stepsAt(clock_.time(), each.rate)) + 1) / each.rate);
    Clock clock = clock_;
    clock.play(false);
    clock.setTime(next);
    setClock(clock);
}

void Session::setClock(const Clock& clock) {
    const bool isOtherTime = clock.time() != clock_.time();
    isStale_ = isStale_ || (isOtherTime && live_ && live_->isAnimated());
    clock_ = clock;
    if (isOtherTime) moveAnimations();
}

void Session::advance(double seconds) {
    if (isStopped_ || !usesTime() || !clock_.advance(seconds)) return;
    if (live_->isAnimated()) isStale_ = true;
    moveAnimations();
}

bool Session::isMoving() const {
    return !isStopped_ && clock_.isPlaying() && clock_.speed() != 0 && usesTime();
}

RenderOptions Session::renderOptions(int width, int height) const {
    RenderOptions options = options_;
    options.texts.clear();
    options.width = width > 0 ? width : width_;
    options.height = height > 0 ? height : height_;
    options.time = clock_.time();
    options.axes = axes_;
    options.labels = labels_;
    if (!chosenFiles_.empty()) options.sceneText = textWithFiles();
    options.viewState = shownView();
    for (const render::Knob& each : knobs_)
        if (each.isChanged()) options.set.push_back(setArgument(live_->scene(), each, knobs_));
    return options;
}

std::string Session::onlyOnScreen() const {
    std::string words;
    const auto add = [&](const std::string& word) { words += (words.empty() ? "" : " and ") + word; };
    if (wireframe_) add("wireframe");
    if (!trials_.states().empty()) add("states of draws that are tried");
    if (debugView_ != DebugView::picture) add("the debug view '" + std::string(nameOf(debugView_)) + "'");
    if (!camera_.empty()) add("the camera '" + camera_ + "'");
    if (live_ && live_->readsMouse() && mouse_ != Mouse{}) add("the mouse");
    if (!options_.texts.empty()) add("text that is not saved");
    return words;
}

bool Session::isChanged() const {
    return view_ != ViewState{} || hasChangedValues(knobs_);
}

}  // namespace glibra::view
