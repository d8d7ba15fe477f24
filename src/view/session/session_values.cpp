// The values of a session: what the user, animations, texts and keys set.

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "glib/text.h"
#include "plan/overrides.h"
#include "view/scene/slider_scale.h"
#include "view/session/session.h"

namespace glibra::view {

const render::Knob* Session::knob(std::string_view program, std::string_view tag) const {
    for (const render::Knob& each : knobs_)
        if (each.tag == tag && (program.empty() || each.title == program)) return &each;
    return nullptr;
}

void Session::applyValue(std::size_t knob) {
    live_->setValue(knobs_[knob]);
    isStopped_ = watchesLoops_ = false;
    isUnwatched_ = true;
    openLoops_.reset();
    std::erase_if(diagnostics_, [](const Diagnostic& each) {
        return each.id == "draw-W08" || each.id == "view-E04" || each.id == "view-E05";
    });
    append(diagnostics_, live_->longLoops());
    isStale_ = true;
}

void Session::setValue(std::size_t knob, std::vector<double> values) {
    if (knob >= knobs_.size()) return;
    render::Knob& changed = knobs_[knob];
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
    if (!on || knobs_[knob].widget != render::Widget::slider || !knobs_[knob].words.empty()) return;
    animations_.push_back(animationOf(knobs_[knob], clock_.time()));
    clock_.play(true);
}

bool Session::isAnimated(std::size_t knob) const {
    return knob < knobs_.size() &&
           std::ranges::any_of(animations_, [&](const Animation& each) { return each.isOf(knobs_[knob]); });
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

render::KeptValues Session::keptValues() const {
    render::KeptValues kept = kept_;
    if (!live_) return kept;
    std::vector<render::Knob> resting = knobs_;
    for (std::size_t i = 0; i < resting.size(); ++i) resting[i].current = restingValue(i);
    kept.keep(live_->scene(), resting);
    return kept;
}

bool Session::setKeptValues(render::KeptValues kept) {
    if (!live_) return false;
    std::vector<render::Knob> wanted = knobs_;
    kept_ = std::move(kept);  // also for programs that the scene lacks until it is mended
    kept_.restore(live_->scene(), wanted);
    bool isChanged = false;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        isChanged = isChanged || wanted[i].current != knobs_[i].current;
        setValue(i, std::move(wanted[i].current));
    }
    return isChanged;
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
    Diagnostics problems;
    for (std::size_t i = 0; i < knobs_.size(); ++i) {
        const render::Knob& knob = knobs_[i];
        if (knob.tag != parsed->name) continue;
        // The control of a variable belongs to no program.
        const bool isMeant = knob.program ? plan::isFor(*parsed, live_->scene().programs[knob.program])
                                          : parsed->program.empty();
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
        setValue(i, std::move(values));
    }
    if (isKnown) return problems;
    std::vector<std::string> names;
    for (const render::Knob& each : knobs_) names.push_back(each.tag);
    return plan::unusedOverrides(std::span(&*parsed, 1), {false}, names);
}

bool Session::pressKey(std::string_view key) {
    if (!live_) return false;
    bool isBound = false;
    const std::vector<scene::KeyBinding> bindings = live_->scene().keys;
    for (const scene::KeyBinding& each : bindings) {
        if (!glib::sameWord(each.key, key)) continue;
        isBound = true;
        if (each.restarts) restart();
        if (each.isHeld) continue;
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

void Session::holdKey(std::string_view key, double seconds) {
    if (!live_) return;
    const std::vector<scene::KeyBinding> bindings = live_->scene().keys;
    for (const scene::KeyBinding& each : bindings) {
        if (!each.isHeld || !glib::sameWord(each.key, key)) continue;
        for (std::size_t i = 0; i < knobs_.size(); ++i) {
            const render::Knob& knob = knobs_[i];
            if (knob.program || knob.tag != each.variable || each.values.empty()) continue;
            std::vector<double> moved = knob.current;
            const std::vector<double>& aim = each.values.front();
            for (std::size_t k = 0; k < moved.size() && k < aim.size(); ++k) {
                moved[k] += (aim[k] - moved[k]) * seconds;
                // A value that the scene states outside of its range can come back into it.
                if (knob.widget == render::Widget::slider)
                    moved[k] = std::clamp(moved[k], std::min(knob.minimum, knob.current[k]),
                                          std::max(knob.maximum, knob.current[k]));
            }
            if (moved == knob.current) continue;
            animate(i, false);
            setValue(i, std::move(moved));
        }
    }
}

Animation animationOf(const render::Knob& knob, double time) {
    Animation animation{knob.program, knob.tag, time, {}, knob.current};
    const SliderScale scale = scaleOf(knob);
    for (const double each : knob.current) animation.phases.push_back(scale.positionOf(each));
    return animation;
}

std::vector<double> valuesAt(const Animation& animation, const render::Knob& knob, double time) {
    const SliderScale scale = scaleOf(knob);
    std::vector<double> values = knob.current;
    for (std::size_t i = 0; i < values.size() && i < animation.phases.size(); ++i) {
        const double phase = animation.phases[i] + (time - animation.begin) / kAnimationSeconds;
        const double turned = phase - 2 * std::floor(phase / 2);
        values[i] = scale.valueAt(turned <= 1 ? turned : 2 - turned, true);
    }
    return values;
}

void Clock::setSpeed(double speed) {
    constexpr double kFastest = 1000;
    if (std::isfinite(speed)) speed_ = std::clamp(speed, -kFastest, kFastest);
}

void Clock::setTime(double seconds) {
    if (std::isfinite(seconds)) time_ = std::max(0.0, seconds);
}

void Clock::step(int frames) {
    playing_ = false;
    setTime(time_ + frames * kFrameSeconds * speed_);
}

bool Clock::advance(double seconds) {
    if (!playing_ || speed_ == 0 || seconds <= 0) return false;
    const double before = time_;
    setTime(time_ + seconds * speed_);
    return time_ != before;
}

}  // namespace glibra::view
