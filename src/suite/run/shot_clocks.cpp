#include "suite/run/shot_clocks.h"

#include <algorithm>

namespace glibra::suite {

bool ShotClocks::mayRestart(const ShotReference& shot) {
    // A shot begins and is judged, perhaps twice each, and others wait for it and go on with it.
    constexpr int kMostRestarts = 32;
    return ++restarts_[shot] <= kMostRestarts;
}

void ShotClocks::hear(const Begins& begins, Clock::time_point now) {
    if (mayRestart(begins.shot)) drawing_ = {begins.shot, now};
}

void ShotClocks::hear(const Phase& phase, Clock::time_point now) {
    switch (phase.kind) {
        case Phase::Kind::awaits:
            if (drawing_ && drawing_->shot == phase.shot) return;
            if (mayRestart(phase.shot)) drawing_ = {phase.shot, now};
            return;
        case Phase::Kind::drawn:
            if (drawing_ && drawing_->shot == phase.shot) drawing_.reset();
            return;
        case Phase::Kind::judges:
            if (mayRestart(phase.shot)) judging_ = {phase.shot, now};
            return;
        case Phase::Kind::recalls:
            if (judging_ && judging_->shot == phase.shot) judging_.reset();
            return;
    }
}

void ShotClocks::hear(const Done& done) {
    for (std::optional<Running>* each : {&drawing_, &judging_})
        if (*each && (*each)->shot == done.shot) each->reset();
}

std::optional<ShotClocks::Clock::time_point> ShotClocks::endOf(const std::optional<Running>& running) const {
    if (!running) return std::nullopt;
    const double seconds = (*limitOf_)(running->shot);
    if (seconds <= 0) return std::nullopt;
    return running->since +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

std::optional<double> ShotClocks::left(Clock::time_point now) const {
    if (!drawing_ && !judging_) return std::nullopt;
    std::optional<double> least;
    for (const auto* each : {&drawing_, &judging_})
        if (const std::optional<Clock::time_point> end = endOf(*each)) {
            const double seconds = std::max(std::chrono::duration<double>(*end - now).count(), 1e-3);
            least = std::min(least.value_or(seconds), seconds);
        }
    return least.value_or(0);
}

std::optional<ShotReference> ShotClocks::latest() const {
    const auto drawn = endOf(drawing_), judged = endOf(judging_);
    if (judged && (!drawn || *judged < *drawn)) return judging_->shot;
    if (drawn) return drawing_->shot;
    return std::nullopt;
}

std::optional<ShotReference> ShotClocks::judged() const {
    if (!judging_) return std::nullopt;
    return judging_->shot;
}

}  // namespace glibra::suite
