#include "view/session/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "base/files.h"
#include "image/compare/compare.h"
#include "image/compare/flip.h"
#include "image/file.h"
#include "suite/file/sweep.h"
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
    const auto error = std::ranges::find(other_.diagnostics(), Severity::error, &Diagnostic::severity);
    return error == other_.diagnostics().end() ? std::string() : toString(*error);
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

}  // namespace glibra::view
