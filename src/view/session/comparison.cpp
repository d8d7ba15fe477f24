#include "view/session/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "base/whole_file.h"
#include "image/compare/flip.h"
#include "image/compare/structure.h"
#include "image/file.h"
#include "suite/file/exercise_file.h"
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
        std::string_view line = text.substr(begin, end - begin);
        if (const std::size_t first = line.find_first_not_of(" \t\"'");
            first != std::string_view::npos && line.substr(first).starts_with("solution"))
            // JSON's strings are such of TOML.
            changed += "solution = " + nlohmann::json(solution.string())
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
    return fmt::format("'{}' cannot be read", scene.string());
}

bool Comparison::follow(const Session& own) {
    if (!own.hasScene() || !other_.hasScene()) return false;
    if (other_.width() != own.width() || other_.height() != own.height())
        other_.resize(own.width(), own.height());
    if (other_.clock().time() != own.clock().time()) other_.setClock(own.clock());
    for (const Knob& each : own.knobs()) {
        const Knob* known = other_.knob(each.title, each.tag);
        if (!known) known = other_.knob("", each.tag);
        if (!known || known->current.size() != each.current.size()) continue;
        std::vector<double> values = each.current;
        if (each.words != known->words) {  // the words of a choice may stand in another order
            const auto index = static_cast<std::size_t>(values.front());
            const auto word = index < each.words.size() ? std::ranges::find(known->words, each.words[index])
                                                        : known->words.end();
            if (word == known->words.end()) continue;
            values.front() = static_cast<double>(word - known->words.begin());
        }
        if (known->current != values)
            other_.setValue(static_cast<std::size_t>(known - other_.knobs().data()), values);
    }
    ViewState view = own.view();
    view.objects.clear();  // they are named by lines, and the other scene has other lines
    if (!(other_.view() == view)) other_.setView(std::move(view));
    if (other_.camera() != own.camera()) other_.setCamera(own.camera());
    const bool isNew = other_.drawIfNeeded();
    const bool isOwnNew = own.framesDrawn() != ownFrames_ || own.timesLoaded() != ownLoads_ || !own_;
    if (isNew || !picture_) picture_ = pictureOf(context_, other_.picture());
    if (isOwnNew) {
        own_ = pictureOf(context_, own.picture());
        ownFrames_ = own.framesDrawn();
        ownLoads_ = own.timesLoaded();
    }
    if (!isNew && !isOwnNew) return false;
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
    const auto bytes = image::readFile(from, {from.string(), {}});
    if (!bytes) return bytes.diagnostics;
    const std::string text =
        withSolution(base::asText(*bytes), fs::absolute(exercise->solution, failure).lexically_normal());
    return image::writeFileAtomically(to, std::as_bytes(std::span(text)), image::NamedBy::program);
}

}  // namespace glibra::view
