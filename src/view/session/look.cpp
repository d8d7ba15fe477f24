#include "view/session/look.h"

#include <algorithm>
#include <variant>

#include "render/draw/view_matrices.h"
#include "scene/view.h"

namespace glibra::view {
namespace {

constexpr int kLargestSide = 16384;

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

}  // namespace

void Look::begin(const scene::Scene& scene) {
    view_ = {};
    camera_.clear();
    picked_.reset();
    width_ = scene.width;
    height_ = scene.height;
}

void Look::leave(const scene::Scene* next) {
    if (next && live_) view_.objects = moved(view_.objects, live_->scene(), *next);
    if (next && picked_) {
        const std::vector<const scene::Draw*> draws = windowDraws(*next);
        const auto ordinal = static_cast<std::size_t>(picked_->ordinal);
        if (ordinal < draws.size() && draws[ordinal]->word == picked_->word)
            picked_->draw = draws[ordinal]->id;
        else
            picked_.reset();
    }
    live_ = nullptr;
}

void Look::enter(render::LiveScene& live) {
    live_ = &live;
    live.drawer().setWireframe(wireframe_);
    setCamera(camera_);
}

void Look::setView(ViewState view) {
    if (view == view_) return;
    view_ = std::move(view);
    changed_();
}

/// How much smaller a perspective must be drawn so that its whole shape fits; 1 or less.
double Look::shrinking() const {
    if (!live_ || !(wholeShape_ > 0) || live_->eyeDistance() != 0)
        return 1;  // an eye that was moved back sees all
    const scene::Draw* last = nullptr;
    for (const scene::Draw* each : windowDraws(live_->scene()))
        if (!std::holds_alternative<scene::ClipSpace>(*each->projection)) last = each;
    if (last == nullptr || !std::holds_alternative<scene::Perspective>(*last->projection)) return 1;
    return std::min(1.0, static_cast<double>(width_) / height_ / wholeShape_);
}

ViewState Look::shownView() const {
    ViewState view = view_;
    if (const double size = shrinking(); size != 1)
        view.scene = render::asNumbers(scene::scaling({size, size, 1}) * render::asMatrix(view_.scene));
    return view;
}

const ViewState& Look::beginFrame() {
    drawnShrinking_ = shrinking();
    if (drawnShrinking_ != 1) smaller_ = shownView();
    return drawnShrinking_ == 1 ? view_ : smaller_;
}

void Look::resetTransforms() {
    ViewState view;
    view.projection = view_.projection;
    view.background = view_.background;
    setView(std::move(view));
}

Matrix Look::transform(TransformMode mode) const {
    ViewState view = view_;
    const Matrix* matrix = matrixOfMode(view, mode, picked_ ? picked_->draw : DrawId());
    return matrix ? *matrix : kIdentity;
}

void Look::setTransform(TransformMode mode, const Matrix& matrix) {
    ViewState view = view_;
    Matrix* changed = matrixOfMode(view, mode, picked_ ? picked_->draw : DrawId());
    if (!changed || !scene::isFinite(render::asMatrix(matrix))) return;
    *changed = matrix;
    std::erase_if(view.objects, [](const ViewState::Object& each) { return each.matrix == kIdentity; });
    setView(std::move(view));
}

const scene::Draw* Look::pickedDraw() const {
    if (!picked_ || !live_) return nullptr;
    for (const scene::Draw* each : windowDraws(live_->scene()))
        if (each->id == picked_->draw) return each;
    return nullptr;
}

Surroundings Look::surroundings(TransformMode mode) const {
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

void Look::drag(TransformMode mode, const Drag& drag) {
    if (!live_ || (mode == TransformMode::object && !pickedDraw())) return;
    const glm::dmat4 before = render::asMatrix(transform(mode));
    const glm::dmat4 after = mode == TransformMode::texture ? draggedTexture(before, drag)
                                                            : dragged(before, drag, surroundings(mode));
    setTransform(mode, render::asNumbers(after));
}

void Look::nextProjection() {
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

void Look::setCamera(const std::string& name) {
    if (!live_) return;
    const auto& cameras = live_->cameras();
    const bool isKnown = std::ranges::find(cameras, name, &scene::NamedCamera::name) != cameras.end();
    camera_ = isKnown ? name : "";
    live_->setCamera(camera_);
    changed_();
}

void Look::nextCamera() {
    if (!live_) return;
    const auto& cameras = live_->cameras();
    const auto now = std::ranges::find(cameras, camera_, &scene::NamedCamera::name);
    const auto next = camera_.empty() ? cameras.begin() : now == cameras.end() ? now : now + 1;
    setCamera(next == cameras.end() ? "" : next->name);
}

void Look::resize(int width, int height) {
    change(width_, std::clamp(width, 1, kLargestSide));
    change(height_, std::clamp(height, 1, kLargestSide));
}

void Look::setWholeShape(double aspect) {
    wholeShape_ = aspect;
    // How far the eye is moved back, on which this depends too, is known only after a frame.
    if (shrinking() != drawnShrinking_) changed_();
}

void Look::setWireframe(bool on) {
    change(wireframe_, on);
    if (live_) live_->drawer().setWireframe(on);
}

void Look::setNormalLength(double length) {
    constexpr double kShortest = .005;
    if (!(length > 0)) return;
    length = std::clamp(length, kShortest, 1.0);
    if (std::exchange(normalLength_, length) != length && debugView_ == DebugView::normals) changed_();
}

void Look::setLike(const Look& other, bool isSameFile) {
    resize(other.width_, other.height_);
    setWholeShape(other.wholeShape_);
    ViewState view = other.view_;
    if (!isSameFile) view.objects.clear();
    setView(std::move(view));
    if (camera_ != other.camera_) setCamera(other.camera_);
    setAxes(other.axes_);
    setWireframe(other.wireframe_);
    setDebugView(other.debugView_);
    setNormalLength(other.normalLength_);
}

}  // namespace glibra::view
