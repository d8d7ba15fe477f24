#include "view/session/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "image/compare/compare.h"
#include "image/compare/flip.h"
#include "image/file.h"
#include "suite/file/sweep.h"
#include "suite/run/exercise_check.h"
#include "view/scene/window_target.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

std::optional<image::Image> pictureOf(gpu::Context& context, const gpu::Target* target) {
    if (!target) return std::nullopt;
    return imageOf(context.capabilities(), *target, 4).value;
}

/// The text of an exercise's file with another path of the solution.
std::string withSolution(std::string_view text, const fs::path& solution) {
    std::string changed;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        if (const std::size_t first = line.find_first_not_of(" \t\"'");
            first != std::string_view::npos && line.substr(first).starts_with("solution"))
            // JSON's strings are such of TOML.
            changed += "solution = " + nlohmann::json(solution.generic_string())
                                           .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
        else
            changed += line;
        changed += '\n';
        begin = end + 1;
    }
    return changed;
}

/// The session shows the moment, paused. Returns the first value that the scene does not have.
std::string show(Session& session, const suite::Moment& moment) {
    session.values().resetAll();
    std::string problem;
    for (const std::string& each : moment.shot.options.set)
        if (const Diagnostics wrong = session.values().setByText(each); !wrong.empty() && problem.empty())
            problem = wrong.front().text;
    session.clock().pauseAt(moment.shot.options.time);
    return problem;
}

std::string errorOf(const Session& session) {
    const auto error = std::ranges::find(session.diagnostics(), Severity::error, &Diagnostic::severity);
    return error == session.diagnostics().end() ? std::string() : toString(*error);
}

}  // namespace

std::string Comparison::open(const fs::path& scene) {
    forgetPictures();
    if (other_.open(scene)) return {};
    return fmt::format("'{}' cannot be read", scene.generic_string());
}

bool Comparison::follow(const Session& own) {
    if (!own.hasScene() || !other_.hasScene()) return false;
    if (!waiting_ && (!own_ || own.framesDrawn() != ownFrames_)) {
        waiting_ = pictureOf(context_, own.picture());
        if (!waiting_) return false;
        ownFrames_ = own.framesDrawn();
        other_.showLike(own);
    }
    if (!waiting_) return false;
    other_.drawIfNeeded();
    if (other_.isDrawing()) return false;
    own_ = std::exchange(waiting_, std::nullopt);
    picture_ = other_.isStopped() ? std::nullopt : pictureOf(context_, other_.picture());
    score_.reset();
    return true;
}

std::string Comparison::problem() const {
    return errorOf(other_);
}

std::optional<Comparison::Score> Comparison::score() {
    if (score_ || !own_ || !picture_ || own_->width != picture_->width || own_->height != picture_->height)
        return score_;
    score_ = Score{image::flip(*picture_, *own_).mean, image::structure(*picture_, *own_).difference};
    return score_;
}

fs::path solutionOf(const fs::path& scene) {
    const Result<suite::Exercise> exercise = suite::readExercise(suite::exerciseFileOf(scene));
    std::error_code failure;
    return exercise && fs::is_regular_file(exercise->solution, failure) ? exercise->solution : fs::path();
}

Diagnostics copyExercise(const fs::path& scene, const fs::path& copy) {
    const fs::path from = suite::exerciseFileOf(scene), to = suite::exerciseFileOf(copy);
    const Result<suite::Exercise> exercise = suite::readExercise(from);
    std::error_code failure;
    if (!exercise || fs::exists(fs::symlink_status(to, failure))) return {};
    const auto bytes = image::readFile(from, {from.generic_string(), {}});
    if (!bytes) return bytes.diagnostics;
    const std::string text =
        withSolution(base::asText(*bytes), fs::absolute(exercise->solution, failure).lexically_normal());
    return image::writeFileAtomically(to, std::as_bytes(std::span(text)), image::NamedBy::program);
}

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
    own_.look().resize(solution_.look().width(), solution_.look().height());
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
