// The view of a session: transforms, projection and camera.

#include <glad/gl.h>

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "base/files.h"
#include "image/file.h"
#include "render/draw/view_matrices.h"
#include "scene/view.h"
#include "view/edit/source_lines.h"
#include "view/scene/window_target.h"
#include "view/session/session.h"

namespace glibra::view {
namespace {

Matrix* matrixOfMode(ViewState& view, TransformMode mode, const DrawId& picked) {
    switch (mode) {
        case TransformMode::scene:
            return &view.scene;
        case TransformMode::eye:
            return &view.eye;
        case TransformMode::texture:
            return &view.texture;
        case TransformMode::object:
            break;
    }
    if (picked.line == 0) return nullptr;
    for (ViewState::Object& each : view.objects)
        if (each.draw() == picked) return &each.matrix;
    return &view.objects.emplace_back(ViewState::Object{picked, kIdentity}).matrix;
}

/// The number that DrawId::file has for the file now; `known` if it draws nothing.
int fileNumber(const scene::Scene& scene, const std::filesystem::path& file, int known) {
    for (const scene::Pass& pass : scene.frame.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<scene::Draw>(&step);
                draw != nullptr && draw->place.file == file)
                return draw->id.file;
    return known;
}

}  // namespace

void Session::setView(ViewState view) {
    if (view == view_) return;
    view_ = std::move(view);
    isStale_ = true;
}

void Session::showLike(const Session& other) {
    resize(other.width_, other.height_);
    setSamples(other.samples_);
    setWholeShape(other.wholeShape_);
    Clock clock = other.clock_;
    clock.setTime(other.pictureTime_);
    if (clock.time() != clock_.time()) setClock(clock);
    for (const render::Knob& each : other.knobs_) {
        const render::Knob* known = knob(each.title, each.tag);
        if (!known) known = knob("", each.tag);
        if (!known || known->current.size() != each.current.size()) continue;
        std::vector<double> values = each.current;
        if (each.words != known->words) {  // the words of a choice may stand in another order
            const auto index = static_cast<std::size_t>(values.front());
            const auto word = index < each.words.size() ? std::ranges::find(known->words, each.words[index])
                                                        : known->words.end();
            if (word == known->words.end()) continue;
            values.front() = static_cast<double>(word - known->words.begin());
        }
        setValue(static_cast<std::size_t>(known - knobs_.data()), std::move(values));
    }
    ViewState view = other.view_;
    if (path_ != other.path_) view.objects.clear();
    setView(std::move(view));
    if (camera_ != other.camera_) setCamera(other.camera_);
    setAxes(other.axes_);
    setWireframe(other.wireframe_);
    setDebugView(other.debugView_);
    setNormalLength(other.normalLength_);
    setMouse(other.mouse_.x, other.mouse_.y, other.mouse_.isDown);
}

void Session::resetTransforms() {
    ViewState view;
    view.projection = view_.projection;
    view.background = view_.background;
    setView(std::move(view));
}

Matrix Session::transform(TransformMode mode) const {
    ViewState view = view_;
    const Matrix* matrix = matrixOfMode(view, mode, picked_ ? picked_->draw : DrawId());
    return matrix ? *matrix : kIdentity;
}

void Session::setTransform(TransformMode mode, const Matrix& matrix) {
    ViewState view = view_;
    Matrix* changed = matrixOfMode(view, mode, picked_ ? picked_->draw : DrawId());
    if (!changed || !scene::isFinite(render::asMatrix(matrix))) return;
    *changed = matrix;
    std::erase_if(view.objects, [](const ViewState::Object& each) { return each.matrix == kIdentity; });
    setView(std::move(view));
}

const scene::Draw* Session::pickedDraw() const {
    if (!picked_ || !live_) return nullptr;
    for (const scene::Draw* each : windowDraws(live_->scene()))
        if (each->id == picked_->draw) return each;
    return nullptr;
}

Surroundings Session::surroundings(TransformMode mode) const {
    ViewState without = view_;
    if (mode == TransformMode::scene) without.scene = kIdentity;
    if (mode == TransformMode::eye) without.eye = kIdentity;
    if (mode == TransformMode::object)
        std::erase_if(without.objects,
                      [&](const ViewState::Object& each) { return each.draw() == picked_->draw; });
    const render::ViewMatrices view(without, live_->scene().view, live_->eyeDistance());
    const scene::Draw* draw = pickedDraw();
    if (mode != TransformMode::object || !draw) {
        // The last one that the window's transforms and a projection act on.
        draw = nullptr;
        const scene::NodeList& frame = live_->scene().frame;
        for (const scene::Pass& pass : frame.passes) {
            if (!render::isMoved(frame, pass)) continue;
            for (const auto& step : pass.steps)
                if (const auto* each = std::get_if<scene::Draw>(&step))
                    if (!std::holds_alternative<scene::ClipSpace>(*each->projection)) draw = each;
        }
    }
    Surroundings around;
    if (!draw) return around;
    const double size = shrinking();
    around.projection = scene::scaling({size, size, 1}) *
                        view.projection(*draw->projection, static_cast<double>(width_) / height_);
    if (mode == TransformMode::object)
        around.after = view.modelView(*draw);
    else
        around.before = view.worldView();
    return around;
}

void Session::drag(TransformMode mode, const Drag& drag) {
    if (!live_ || (mode == TransformMode::object && !pickedDraw())) return;
    const glm::dmat4 before = render::asMatrix(transform(mode));
    const glm::dmat4 after = mode == TransformMode::texture ? draggedTexture(before, drag)
                                                            : dragged(before, drag, surroundings(mode));
    setTransform(mode, render::asNumbers(after));
}

void Session::nextProjection() {
    bool isDeep = false, isFlat = false;
    if (live_)
        for (const scene::Draw* each : windowDraws(live_->scene())) {
            isDeep = isDeep || std::holds_alternative<scene::Perspective>(*each->projection);
            isFlat = isFlat || std::holds_alternative<scene::Orthographic>(*each->projection);
        }
    std::vector<ProjectionMode> round{ProjectionMode::scene};
    if (isDeep) round.push_back(ProjectionMode::orthographic);
    if (isFlat) round.push_back(ProjectionMode::perspective);
    const auto now = std::find(round.begin(), round.end(), view_.projection);
    ViewState view = view_;
    view.projection = now == round.end() || now + 1 == round.end() ? ProjectionMode::scene : *(now + 1);
    setView(std::move(view));
}

void Session::setCamera(const std::string& name) {
    if (!live_) return;
    const auto& cameras = live_->cameras();
    const bool isKnown = std::ranges::find(cameras, name, &scene::NamedCamera::name) != cameras.end();
    camera_ = isKnown ? name : "";
    live_->setCamera(camera_);
    isStale_ = true;
}

void Session::nextCamera() {
    if (!live_) return;
    const auto& cameras = live_->cameras();
    const auto now = std::ranges::find(cameras, camera_, &scene::NamedCamera::name);
    const auto next = camera_.empty() ? cameras.begin() : now == cameras.end() ? now : now + 1;
    setCamera(next == cameras.end() ? "" : next->name);
}

void Session::setMouse(double x, double y, bool isDown) {
    const Mouse mouse{x, y, isDown};
    if (mouse == mouse_) return;
    mouse_ = mouse;
    if (!live_) return;
    live_->setMouse(x, y, isDown);
    isStale_ = isStale_ || live_->readsMouse();
}

/// How much smaller a perspective must be drawn so that its whole shape fits; 1 or less.
double Session::shrinking() const {
    if (!live_ || !(wholeShape_ > 0) || live_->eyeDistance() != 0)
        return 1;  // an eye that was moved back sees all
    const scene::Draw* last = nullptr;
    for (const scene::Draw* each : windowDraws(live_->scene()))
        if (!std::holds_alternative<scene::ClipSpace>(*each->projection)) last = each;
    if (last == nullptr || !std::holds_alternative<scene::Perspective>(*last->projection)) return 1;
    return std::min(1.0, static_cast<double>(width_) / height_ / wholeShape_);
}

/// The view as it is drawn: what makes the scene smaller is part of the projection, as the scene's transform
/// is.
ViewState Session::shownView() const {
    ViewState view = view_;
    if (const double size = shrinking(); size != 1)
        view.scene = render::asNumbers(scene::scaling({size, size, 1}) * render::asMatrix(view_.scene));
    return view;
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

}  // namespace glibra::view
