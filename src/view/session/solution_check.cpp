#include "view/session/solution_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "suite/run/exercise_check.h"
#include "view/scene/window_target.h"

namespace glibra::view {
namespace {

/// The session shows the moment, paused. Returns the first value that the scene does not have.
std::string show(Session& session, const suite::Moment& moment) {
    session.resetValues();
    std::string problem;
    for (const std::string& each : moment.shot.options.set)
        if (const Diagnostics wrong = session.setByText(each); !wrong.empty() && problem.empty())
            problem = wrong.front().text;
    Clock clock;
    clock.play(false);
    clock.setTime(moment.shot.options.time);
    session.setClock(clock);
    return problem;
}

std::string errorOf(const Session& session) {
    const auto error = std::ranges::find(session.diagnostics(), Severity::error, &Diagnostic::severity);
    return error == session.diagnostics().end() ? std::string() : toString(*error);
}

}  // namespace

SolutionCheck::SolutionCheck(gpu::Context& context, const RenderOptions& options)
    : context_(context), solution_(context, options), own_(context, options) {
    solution_.setContained(true);
    own_.setContained(true);
}

bool SolutionCheck::follow(const Session& shown) {
    if (!shown.hasScene()) return false;
    if (shown.path() != path_ || shown.timesLoaded() != loads_) begin(shown);
    if (state_ == State::drawing) drawMoment();
    return state_ == State::drawing;
}

std::string SolutionCheck::text() const {
    switch (state_) {
        case State::none:
            return {};
        case State::drawing:
            return fmt::format("comparing: {} of {} sets of values", next_, moments_.size());
        case State::solved:
            return moments_.size() == 1 ? std::string("solved")
                                        : fmt::format("solved, with {} sets of values", moments_.size());
        case State::unsolved:
            return "not solved yet: " + why_;
    }
    return {};
}

void SolutionCheck::releaseDevice() {
    solution_.releaseDevice();
    own_.releaseDevice();
}

void SolutionCheck::restoreDevice() {
    solution_.restoreDevice();
    own_.restoreDevice();
    loads_ = 0;
}

void SolutionCheck::refuse(std::string why) {
    why_ = std::move(why);
    state_ = State::unsolved;
}

void SolutionCheck::begin(const Session& shown) {
    path_ = shown.path();
    loads_ = shown.timesLoaded();
    next_ = 0;
    isSet_ = false;
    state_ = State::none;
    const std::filesystem::path file = suite::exerciseFileOf(path_);
    const Result<suite::Exercise> exercise = suite::readExercise(file);
    if (!exercise) return;
    Result<std::vector<suite::Moment>> moments = suite::momentsOf(*exercise, file);
    if (!moments) return refuse(toString(moments.diagnostics.front()));
    moments_ = std::move(*moments);
    if (solution_.path() != exercise->solution && !solution_.open(exercise->solution))
        return refuse("the solution cannot be read");
    const bool isKnown = own_.path() == path_;
    if (!isKnown && !own_.open(path_)) return refuse("the scene cannot be read");
    if (isKnown || !shown.texts().empty()) {
        own_.setTexts(shown.texts());
        if (!own_.reload()) return refuse("the scene cannot be read");
    }
    own_.resize(solution_.width(), solution_.height());
    state_ = State::drawing;
}

void SolutionCheck::drawMoment() {
    const suite::Moment& moment = moments_[next_];
    if (!isSet_) {
        show(solution_, moment);
        if (std::string missing = show(own_, moment); !missing.empty()) return refuse(std::move(missing));
        isSet_ = true;
    }
    std::array<std::optional<image::Image>, 2> pictures;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        Session& session = i == 0 ? solution_ : own_;
        session.drawIfNeeded();
        if (session.isDrawing()) return;
        if (std::string error = errorOf(session); !error.empty()) return refuse(std::move(error));
        if (session.picture()) pictures.at(i) = imageOf(context_.capabilities(), *session.picture(), 3).value;
        if (!pictures.at(i)) return refuse("the picture cannot be read");
    }
    isSet_ = false;
    if (const std::string why = suite::whyUnsolved(moment.has, *pictures[0], *pictures[1]); !why.empty())
        return refuse(moment.label.empty() ? why : "at " + moment.label + " " + why);
    if (++next_ == moments_.size()) state_ = State::solved;
}

}  // namespace glibra::view
