#include "view/session/scene_values.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "plan/overrides.h"
#include "view/scene/slider_scale.h"

namespace glibra::view {

void Clock::setState(const State& state) {
    play(state.isPlaying);
    setSpeed(state.speed);
    setTime(state.time);
}

void Clock::setSpeed(double speed) {
    constexpr double kFastest = 1000;
    if (std::isfinite(speed)) state_.speed = std::clamp(speed, -kFastest, kFastest);
}

void Clock::setTime(double seconds) {
    if (!std::isfinite(seconds)) return;
    seconds = std::max(0.0, seconds);
    if (std::exchange(state_.time, seconds) != seconds) changed_();
}

void Clock::pauseAt(double seconds) {
    play(false);
    setTime(seconds);
}

void Clock::advance(double seconds) {
    if (isPlaying() && seconds > 0) setTime(time() + seconds * speed());
}

bool canAnimate(const render::Knob& knob) {
    return knob.widget == render::Widget::slider && knob.words.empty();
}

void SceneValues::leave() {
    if (scene_) kept_.keep(*scene_, knobs_);
    scene_ = nullptr;
}

void SceneValues::enter(const scene::Scene& scene, std::vector<render::Knob> knobs) {
    scene_ = &scene;
    const std::vector<render::Knob> before = std::exchange(knobs_, std::move(knobs));
    kept_.restore(scene, knobs_);
    std::vector<std::optional<Animation>> animated(knobs_.size());
    animated.swap(animations_);
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (!animated[i]) continue;
        // Animations go with their programs, wherever these stand now, and under another name.
        const auto isSame = [&](const render::Knob& each) {
            return each.title == before[i].title && each.tag == before[i].tag;
        };
        const auto isRenamed = [&](const render::Knob& each) {
            return each.program == before[i].program && each.tag == before[i].tag &&
                   std::ranges::find(before, each.title, &render::Knob::title) == before.end();
        };
        auto now = std::ranges::find_if(knobs_, isSame);
        if (now == knobs_.end()) now = std::ranges::find_if(knobs_, isRenamed);
        if (now != knobs_.end() && now->widget == render::Widget::slider &&
            now->current.size() == animated[i]->phases.size())
            animations_[static_cast<std::size_t>(now - knobs_.begin())] = std::move(animated[i]);
    }
    for (const render::Knob& each : knobs_)
        if (each.isChanged()) changed_(each);
}

void SceneValues::clear() {
    scene_ = nullptr;
    knobs_.clear();
    animations_.clear();
    kept_.forget();
}

const render::Knob* SceneValues::knob(std::string_view program, std::string_view tag) const {
    for (const render::Knob& each : knobs_)
        if (each.tag == tag && (program.empty() || each.title == program)) return &each;
    return nullptr;
}

bool SceneValues::isChanged() const {
    return std::ranges::any_of(knobs_, &render::Knob::isChanged);
}

void SceneValues::set(std::size_t knob, std::vector<double> values) {
    if (knob >= knobs_.size()) return;
    render::Knob& changed = knobs_[knob];
    std::vector<double> wanted = changed.current;
    for (std::size_t i = 0; i < std::min(values.size(), wanted.size()); ++i) {
        if (!std::isfinite(static_cast<float>(values[i]))) return;
        wanted[i] = changed.isInteger() ? std::trunc(values[i]) : values[i];
    }
    if (wanted == changed.current) return;
    changed.current = std::move(wanted);
    changed_(changed);
}

void SceneValues::reset(std::size_t knob) {
    animate(knob, false);
    if (knob < knobs_.size()) set(knob, std::vector<double>(knobs_[knob].initial));
}

void SceneValues::resetAll() {
    for (std::size_t i = 0; i < knobs_.size(); ++i) reset(i);
    kept_.forget();
}

Diagnostics SceneValues::setByText(const std::string& argument) {
    const Result<plan::Override> parsed = plan::parseOverride(argument);
    if (!parsed) return parsed.diagnostics;
    if (!parsed->word.empty()) {
        for (std::size_t i = 0; i < knobs_.size(); ++i) {
            const std::vector<std::string>& words = knobs_[i].words;
            const auto word = std::find(words.begin(), words.end(), parsed->word);
            if (knobs_[i].tag != parsed->name || word == words.end()) continue;
            set(i, {static_cast<double>(word - words.begin())});
            return {};
        }
        return {plan::notAChoice(parsed->name, parsed->word)};
    }
    bool isKnown = false;
    Diagnostics problems;
    for (std::size_t i = 0; i < knobs_.size(); ++i) {
        const render::Knob& knob = knobs_[i];
        if (knob.tag != parsed->name) continue;
        // The control of a variable belongs to no program.
        const bool isMeant =
            knob.program ? plan::isFor(*parsed, scene_->programs[knob.program]) : parsed->program.empty();
        if (!isMeant) continue;
        isKnown = true;
        const std::size_t components = knob.current.size();
        if (!knob.program && parsed->values.size() != components) {
            problems.push_back(plan::misfit(knob.tag, parsed->values, components));
            continue;
        }
        // As `render --set` reads other numbers of values: one for all components, 0 for those that lack.
        std::vector<double> values = parsed->values;
        values.resize(components, values.size() == 1 ? values.front() : 0.0);
        set(i, std::move(values));
    }
    if (isKnown) return problems;
    std::vector<std::string> names;
    for (const render::Knob& each : knobs_) names.push_back(each.tag);
    return plan::unusedOverrides(std::span(&*parsed, 1), {false}, names);
}

void SceneValues::setLike(const SceneValues& other) {
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
        set(static_cast<std::size_t>(known - knobs_.data()), std::move(values));
    }
}

void SceneValues::press(const scene::KeyBinding& key) {
    for (std::size_t i = 0; i < knobs_.size(); ++i) {
        if (knobs_[i].program || knobs_[i].tag != key.variable || key.values.empty()) continue;
        const auto now = std::find(key.values.begin(), key.values.end(), knobs_[i].current);
        animate(i, false);
        const bool isLast = now == key.values.end() || now + 1 == key.values.end();
        set(i, isLast ? key.values.front() : *(now + 1));
    }
}

void SceneValues::hold(const scene::KeyBinding& key, double seconds) {
    for (std::size_t i = 0; i < knobs_.size(); ++i) {
        const render::Knob& knob = knobs_[i];
        if (knob.program || knob.tag != key.variable || key.values.empty()) continue;
        std::vector<double> moved = knob.current;
        const std::vector<double>& aim = key.values.front();
        for (std::size_t k = 0; k < moved.size() && k < aim.size(); ++k) {
            moved[k] += (aim[k] - moved[k]) * seconds;
            // A value that the scene states outside of its range can come back into it.
            if (knob.widget == render::Widget::slider)
                moved[k] = std::clamp(moved[k], std::min(knob.minimum, knob.current[k]),
                                      std::max(knob.maximum, knob.current[k]));
        }
        if (moved == knob.current) continue;
        animate(i, false);
        set(i, std::move(moved));
    }
}

std::vector<double> SceneValues::valuesAt(const Animation& animation, const render::Knob& knob, double time) {
    constexpr double kSeconds = 4;  // from one end to the other, evenly on the slider's scale
    const SliderScale scale = scaleOf(knob);
    std::vector<double> values = knob.current;
    for (std::size_t i = 0; i < values.size() && i < animation.phases.size(); ++i) {
        const double phase = animation.phases[i] + (time - animation.begin) / kSeconds;
        const double turned = phase - 2 * std::floor(phase / 2);
        values[i] = scale.valueAt(turned <= 1 ? turned : 2 - turned, true);
    }
    return values;
}

void SceneValues::animate(std::size_t knob, bool on) {
    if (knob >= knobs_.size()) return;
    const render::Knob& moved = knobs_[knob];
    animations_[knob].reset();
    if (!on || !canAnimate(moved)) return;
    Animation& animation = animations_[knob].emplace(Animation{clock_.time(), {}, moved.current});
    const SliderScale scale = scaleOf(moved);
    for (const double each : moved.current) animation.phases.push_back(scale.positionOf(each));
    clock_.play(true);
}

bool SceneValues::isAnimated(std::size_t knob) const {
    return knob < knobs_.size() && animations_[knob];
}

bool SceneValues::isAnyAnimated() const {
    return std::ranges::any_of(animations_, [](const auto& each) { return each.has_value(); });
}

bool SceneValues::undoAnimations() {
    const bool isAny = isAnyAnimated();
    for (std::size_t i = 0; i < knobs_.size(); ++i)
        if (const auto ended = std::exchange(animations_[i], std::nullopt)) set(i, ended->before);
    return isAny;
}

void SceneValues::followClock() {
    for (std::size_t i = 0; i < knobs_.size(); ++i)
        if (animations_[i]) set(i, valuesAt(*animations_[i], knobs_[i], clock_.time()));
}

const std::vector<double>& SceneValues::resting(std::size_t knob) const {
    return animations_[knob] ? animations_[knob]->before : knobs_[knob].current;
}

render::KeptValues SceneValues::kept() const {
    render::KeptValues kept = kept_;
    if (!scene_) return kept;
    std::vector<render::Knob> atRest = knobs_;
    for (std::size_t i = 0; i < atRest.size(); ++i) atRest[i].current = resting(i);
    kept.keep(*scene_, atRest);
    return kept;
}

bool SceneValues::setKept(render::KeptValues kept) {
    if (!scene_) return false;
    std::vector<render::Knob> wanted = knobs_;
    kept_ = std::move(kept);  // also for programs that the scene lacks until it is mended
    kept_.restore(*scene_, wanted);
    bool isChanged = false;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        isChanged = isChanged || wanted[i].current != knobs_[i].current;
        set(i, std::move(wanted[i].current));
    }
    return isChanged;
}

}  // namespace glibra::view
