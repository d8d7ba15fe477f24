#include "view/session/session.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "glib/text.h"
#include "image/file.h"
#include "plan/overrides.h"
#include "render/draw/view_matrices.h"
#include "scene/matrices.h"

namespace glibra::view {
namespace {

constexpr std::size_t kMostDiagnostics = 200;
constexpr int kLargestSide = 16384;

/// The draws into the window, in order.
std::vector<const scene::Draw*> windowDraws(const scene::Scene& scene) {
    std::vector<const scene::Draw*> draws;
    for (const scene::Pass& pass : scene.frame.passes) {
        if (!pass.isWindow) continue;
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<scene::Draw>(&step)) draws.push_back(draw);
    }
    return draws;
}

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

Session::Session(gpu::Context& context, RenderOptions options)
    : context_(context), options_(std::move(options)) {}

/// The scene's text with the files that the user has chosen. Nothing if there are none, or if the scene
/// cannot be read.
std::optional<std::string> Session::textWithFiles() const {
    const auto bytes = image::readFile(path_, {path_.string(), {}});
    if (!bytes) return std::nullopt;
    return withFiles({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, chosenFiles_);
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
    const auto bytes = image::readFile(path_, {path_.string(), {}});
    if (!bytes) return toString(bytes.diagnostics.front());
    auto chosen = chosenFile({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, place, file);
    if (!chosen) return "the scene has changed meanwhile; choose the file again";
    if (chosen->name.find('"') != std::string::npos)
        return "a scene cannot name a file with a quotation mark in its name: " + chosen->name;
    chosenFiles_.push_back(std::move(*chosen));
    return {};
}

bool Session::open(const std::filesystem::path& path) {
    options_.texts.clear();
    LiveScene::Loading loading = LiveScene::load(context_, path, options_, nullptr);
    if (!loading.scene) {
        diagnostics_ = std::move(loading.diagnostics);
        return false;
    }
    path_ = path;
    chosenFiles_.clear();
    isVerbose_ = false;
    kept_.forget();
    view_ = {};
    camera_.clear();
    clock_ = {};
    animations_.clear();
    width_ = loading.scene->scene().width;
    height_ = loading.scene->scene().height;
    take(std::move(loading), false);
    return true;
}

bool Session::reload() {
    if (path_.empty()) return false;
    LiveScene::Loading loading = LiveScene::load(context_, path_, loadOptions(), live_.get());
    if (!loading.scene) {
        diagnostics_ = std::move(loading.diagnostics);
        if (loading.isPreviousLost) dropScene();
        return false;
    }
    take(std::move(loading), true);
    return true;
}

void Session::dropScene() {
    debugRenderer_.reset();
    knobs_.clear();
    animations_.clear();
    picked_.reset();
    live_.reset();
}

void Session::take(LiveScene::Loading loading, bool sameScene) {
    if (live_) kept_.keep(live_->scene(), knobs_);
    if (sameScene && live_) {
        view_.objects = moved(view_.objects, live_->scene(), loading.scene->scene());
    } else {
        kept_.forget();
    }
    if (picked_) {
        const std::vector<const scene::Draw*> draws = windowDraws(loading.scene->scene());
        const auto ordinal = static_cast<std::size_t>(picked_->ordinal);
        if (sameScene && ordinal < draws.size() && draws[ordinal]->word == picked_->word)
            picked_->draw = draws[ordinal]->id;
        else
            picked_.reset();
    }
    debugRenderer_.reset();
    objectTimer_.forget();
    live_ = std::move(loading.scene);
    diagnostics_ = std::move(loading.diagnostics);
    knobs_ = live_->knobs();
    kept_.restore(live_->scene(), knobs_);
    std::erase_if(animations_, [&](const Animation& each) {
        return std::none_of(knobs_.begin(), knobs_.end(), [&](const Knob& knob) {
            return each.isOf(knob) && knob.widget == Widget::slider &&
                   knob.current.size() == each.phases.size();
        });
    });
    for (std::size_t i = 0; i < knobs_.size(); ++i)
        if (knobs_[i].isChanged()) applyValue(i);
    live_->drawer().setWireframe(wireframe_);
    live_->setMouse(mouse_.x, mouse_.y, mouse_.isDown);
    setCamera(camera_);
    isStale_ = true;
    ++timesLoaded_;
}

const Knob* Session::knob(std::string_view program, std::string_view tag) const {
    for (const Knob& each : knobs_)
        if (each.tag == tag && (program.empty() || each.title == program)) return &each;
    return nullptr;
}

void Session::applyValue(std::size_t knob) {
    live_->setValue(knobs_[knob]);
    std::erase_if(diagnostics_, [](const Diagnostic& each) { return each.id == "draw-W08"; });
    append(diagnostics_, live_->longLoops());
    isStale_ = true;
}

void Session::setValue(std::size_t knob, std::vector<double> values) {
    if (knob >= knobs_.size()) return;
    Knob& changed = knobs_[knob];
    std::vector<double> wanted = changed.current;
    for (std::size_t i = 0; i < std::min(values.size(), wanted.size()); ++i) {
        if (!std::isfinite(static_cast<float>(values[i]))) return;
        wanted[i] = changed.isInteger() ? std::trunc(values[i]) : values[i];
    }
    if (wanted == changed.current) return;
    changed.current = std::move(wanted);
    applyValue(knob);
}

void Session::animate(std::size_t knob, bool on) {
    if (knob >= knobs_.size()) return;
    std::erase_if(animations_, [&](const Animation& each) { return each.isOf(knobs_[knob]); });
    if (!on || knobs_[knob].widget != Widget::slider || !knobs_[knob].words.empty()) return;
    animations_.push_back(animationOf(knobs_[knob], clock_.time()));
    clock_.play(true);
}

bool Session::isAnimated(std::size_t knob) const {
    return knob < knobs_.size() &&
           std::any_of(animations_.begin(), animations_.end(),
                       [&](const Animation& each) { return each.isOf(knobs_[knob]); });
}

bool Session::undoAnimations() {
    const std::vector<Animation> ended = std::exchange(animations_, {});
    for (const Animation& each : ended)
        for (std::size_t i = 0; i < knobs_.size(); ++i)
            if (each.isOf(knobs_[i])) setValue(i, each.before);
    return !ended.empty();
}

const std::vector<double>& Session::restingValue(std::size_t knob) const {
    for (const Animation& each : animations_)
        if (each.isOf(knobs_[knob])) return each.before;
    return knobs_[knob].current;
}

void Session::moveAnimations() {
    for (const Animation& each : animations_)
        for (std::size_t i = 0; i < knobs_.size(); ++i)
            if (each.isOf(knobs_[i])) setValue(i, valuesAt(each, knobs_[i], clock_.time()));
}

void Session::resetValue(std::size_t knob) {
    animate(knob, false);
    if (knob < knobs_.size()) setValue(knob, std::vector<double>(knobs_[knob].initial));
}

void Session::resetValues() {
    for (std::size_t i = 0; i < knobs_.size(); ++i) resetValue(i);
    kept_.forget();
}

Diagnostics Session::setByText(const std::string& argument) {
    const Result<plan::Override> parsed = plan::parseOverride(argument);
    if (!parsed) return parsed.diagnostics;
    if (!parsed->word.empty()) {
        for (std::size_t i = 0; i < knobs_.size(); ++i) {
            const std::vector<std::string>& words = knobs_[i].words;
            const auto word = std::find(words.begin(), words.end(), parsed->word);
            if (knobs_[i].tag != parsed->name || word == words.end()) continue;
            setValue(i, {static_cast<double>(word - words.begin())});
            return {};
        }
        return {plan::notAChoice(parsed->name, parsed->word)};
    }
    bool isKnown = false;
    for (std::size_t i = 0; i < knobs_.size(); ++i) {
        const std::string line = std::to_string(live_->scene().programs[knobs_[i].program].place.line);
        const std::string& name = live_->scene().programs[knobs_[i].program].name;
        if (knobs_[i].tag != parsed->name) continue;
        if (!parsed->program.empty() && parsed->program != name && parsed->program != line) continue;
        isKnown = true;
        setValue(i, parsed->values);
    }
    if (isKnown) return {};
    std::vector<std::string> names;
    for (const Knob& each : knobs_) names.push_back(each.tag);
    return plan::unusedOverrides(std::span(&*parsed, 1), {false}, names);
}

void Session::setView(ViewState view) {
    if (view == view_) return;
    view_ = std::move(view);
    isStale_ = true;
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
                    if (!std::holds_alternative<scene::ClipSpace>(each->projection)) draw = each;
        }
    }
    Surroundings around;
    if (!draw) return around;
    const double size = shrinking();
    around.projection = scene::scaling({size, size, 1}) *
                        view.projection(draw->projection, static_cast<double>(width_) / height_);
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
            isDeep = isDeep || std::holds_alternative<scene::Perspective>(each->projection);
            isFlat = isFlat || std::holds_alternative<scene::Orthographic>(each->projection);
        }
    std::vector<ProjectionMode> round{ProjectionMode::scene};
    if (isDeep) round.push_back(ProjectionMode::orthographic);
    if (isFlat) round.push_back(ProjectionMode::perspective);
    const auto now = std::find(round.begin(), round.end(), view_.projection);
    ViewState view = view_;
    view.projection = now == round.end() || now + 1 == round.end() ? ProjectionMode::scene : *(now + 1);
    setView(std::move(view));
}

void Session::setMeasuresObjects(bool on) {
    if (on == measuresObjects_) return;
    measuresObjects_ = on;
    objectTimer_.forget();
    isStale_ = isStale_ || on;
}

void Session::keepTextures() {
    if (!live_) return;
    Diagnostics diagnostics;
    if (live_->keepTextures(diagnostics)) {
        debugRenderer_.reset();
        isStale_ = true;
    }
    for (Diagnostic& each : diagnostics) addOnce(diagnostics_, std::move(each));
}

void Session::setAxes(bool on) {
    isStale_ = isStale_ || on != axes_;
    axes_ = on;
}

void Session::setWireframe(bool on) {
    isStale_ = isStale_ || on != wireframe_;
    wireframe_ = on;
    if (live_) live_->drawer().setWireframe(on);
}

void Session::setDebugView(DebugView kind) {
    isStale_ = isStale_ || kind != debugView_;
    debugView_ = kind;
}

void Session::setNormalLength(double length) {
    constexpr double kShortest = .005;
    if (!(length > 0)) return;
    length = std::clamp(length, kShortest, 1.0);
    isStale_ = isStale_ || (length != normalLength_ && debugView_ == DebugView::normals);
    normalLength_ = length;
}

const TexelImage& Session::debugNumbers() const {
    static const TexelImage kNone;
    return debugRenderer_ && debugView_ != DebugView::picture ? debugRenderer_->numbers() : kNone;
}

void Session::setCamera(const std::string& name) {
    if (!live_) return;
    const auto& cameras = live_->cameras();
    const bool isKnown = std::any_of(cameras.begin(), cameras.end(),
                                     [&](const scene::NamedCamera& each) { return each.name == name; });
    camera_ = isKnown ? name : "";
    live_->setCamera(camera_);
    isStale_ = true;
}

void Session::nextCamera() {
    if (!live_) return;
    const auto& cameras = live_->cameras();
    if (camera_.empty()) return setCamera(cameras.empty() ? "" : cameras.front().name);
    for (std::size_t i = 0; i + 1 < cameras.size(); ++i)
        if (cameras[i].name == camera_) return setCamera(cameras[i + 1].name);
    setCamera("");
}

void Session::setMouse(double x, double y, bool isDown) {
    const Mouse mouse{x, y, isDown};
    if (mouse == mouse_) return;
    mouse_ = mouse;
    if (!live_) return;
    live_->setMouse(x, y, isDown);
    isStale_ = isStale_ || live_->readsMouse();
}

bool Session::pressKey(std::string_view key) {
    if (!live_) return false;
    bool isBound = false;
    const std::vector<scene::KeyBinding> bindings = live_->scene().keys;
    for (const scene::KeyBinding& each : bindings) {
        if (!glib::sameWord(each.key, key)) continue;
        isBound = true;
        if (each.restarts) restart();
        for (std::size_t i = 0; i < knobs_.size() && !each.values.empty(); ++i) {
            if (knobs_[i].program || knobs_[i].tag != each.variable) continue;
            const auto now = std::find(each.values.begin(), each.values.end(), knobs_[i].current);
            animate(i, false);
            const bool isLast = now == each.values.end() || now + 1 == each.values.end();
            setValue(i, isLast ? each.values.front() : *(now + 1));
        }
    }
    return isBound;
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
    isStale_ = isStale_ || (clock.time() != clock_.time() && live_ && live_->isAnimated());
    const bool isOtherTime = clock.time() != clock_.time();
    clock_ = clock;
    if (isOtherTime) moveAnimations();
}

void Session::advance(double seconds) {
    if (!usesTime() || !clock_.advance(seconds)) return;
    if (live_->isAnimated()) isStale_ = true;
    moveAnimations();
}

bool Session::isMoving() const {
    return clock_.isPlaying() && clock_.speed() != 0 && usesTime();
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
    target_.reset();
    isStale_ = true;
}

void Session::setWholeShape(double aspect) {
    wholeShape_ = aspect;
    // How far the eye is moved back, on which this depends too, is known only after a frame.
    isStale_ = isStale_ || shrinking() != drawnShrinking_;
}

/// How much smaller a perspective must be drawn so that its whole shape fits; 1 or less.
double Session::shrinking() const {
    if (!live_ || !(wholeShape_ > 0) || live_->eyeDistance() != 0)
        return 1;  // an eye that was moved back sees all
    const scene::Draw* last = nullptr;
    for (const scene::Draw* each : windowDraws(live_->scene()))
        if (!std::holds_alternative<scene::ClipSpace>(each->projection)) last = each;
    if (last == nullptr || !std::holds_alternative<scene::Perspective>(last->projection)) return 1;
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

Diagnostics Session::drawShown() {
    drawnShrinking_ = shrinking();
    // Frames of a moving scene allocate no memory, so the view is copied only if it differs.
    std::optional<ViewState> smaller;
    const ViewState& shown = drawnShrinking_ == 1 ? view_ : smaller.emplace(shownView());
    Diagnostics diagnostics;
    if (debugView_ == DebugView::picture) {
        if (!measuresObjects_) return live_->draw(*target_, shown, clock_.time(), axes_);
        live_->moveTo(width_, height_, clock_.time(), diagnostics);  // before the drawer is used
        if (!isMoving()) objectTimer_.forget();                      // single frames have nothing in common
        objectTimer_.begin(live_->drawer(), live_->plan());
        append(diagnostics, live_->draw(*target_, shown, clock_.time(), axes_));
        objectTimer_.end(live_->drawer());
        return diagnostics;
    }
    objectTimer_.forget();
    if (live_->moveTo(width_, height_, clock_.time(), diagnostics)) debugRenderer_.reset();
    if (!debugRenderer_) debugRenderer_.emplace(context_, *live_);
    append(diagnostics,
           debugRenderer_->draw(*target_, shown, {debugView_, normalLength_, clock_.time(), axes_}));
    return diagnostics;
}

/// Makes the target anew if its size or its samples differ. Returns false if there is no memory for it.
bool Session::makeTarget(std::optional<gpu::Target>& target, int samples) {
    if (target && target->width() == width_ && target->height() == height_ &&
        (target->samples() > 1) == (samples > 1))
        return true;
    target.reset();
    Result<gpu::Target> made =
        gpu::Target::window(context_.capabilities(), width_, height_, gpu::TexelFormat::rgba8, samples,
                            gpu::TexelFormat::depth24_stencil8);
    if (!made) {
        append(diagnostics_, std::move(made.diagnostics));
        return false;
    }
    target = std::move(made.value);
    return true;
}

bool Session::drawIfNeeded() {
    if (!isStale_ || !live_) return false;
    // Debug views show numbers, which must not be mixed.
    const bool isMixed = debugView_ == DebugView::picture || debugView_ == DebugView::normals;
    if (!makeTarget(target_, isMixed ? samples_ : 1)) {
        isStale_ = false;
        return false;
    }
    for (Diagnostic& each : drawShown()) addOnce(diagnostics_, std::move(each));
    isStale_ = false;
    ++framesDrawn_;
    return true;
}

const gpu::Target* Session::plainPicture() {
    if (!live_ || !target_ || target_->samples() == 1) return picture();
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
    if (const gpu::Target* plain = plainPicture(); live_ && plain)
        picked_ = pick(*live_, *plain, clock_.time(), x, y);
    plainFrame_ = 0;
    // Picking draws the pixel without the debug view.
    if (debugView_ != DebugView::picture) isStale_ = true;
}

ProbedPixel Session::probe(int x, int y) {
    drawIfNeeded();
    if (!live_ || !target_) return {};
    ProbedPixel pixel =
        probePixel(context_, *live_, target_->width(), target_->height(), clock_.time(), x, y);
    if (debugRenderer_) debugRenderer_->forgetPlan();
    return pixel;
}

void Session::clearPick() {
    picked_.reset();
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
    for (const Knob& each : knobs_)
        if (each.isChanged()) options.set.push_back(setArgument(live_->scene(), each, knobs_));
    return options;
}

std::string Session::onlyOnScreen() const {
    std::string words;
    const auto add = [&](const std::string& word) { words += (words.empty() ? "" : " and ") + word; };
    if (wireframe_) add("wireframe");
    if (debugView_ != DebugView::picture) add("the debug view '" + std::string(nameOf(debugView_)) + "'");
    if (!camera_.empty()) add("the camera '" + camera_ + "'");
    if (live_ && live_->readsMouse() && mouse_ != Mouse{}) add("the mouse");
    if (!options_.texts.empty()) add("text that is not saved");
    return words;
}

bool Session::isChanged() const {
    return view_ != ViewState{} ||
           std::any_of(knobs_.begin(), knobs_.end(), [](const Knob& each) { return each.isChanged(); });
}

}  // namespace glibra::view
