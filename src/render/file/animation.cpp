#include "render/file/animation.h"

#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>

#include "base/files.h"
#include "image/file.h"
#include "render/draw/frame.h"
#include "render/file/scene_inputs.h"
#include "render/scene_renderer.h"
#include "scene/file_lookup.h"

namespace glibra::render {
namespace {

/// Searches shader files for one word.
class TimerSearch {
  public:
    TimerSearch(const scene::Scene& scene, const RenderOptions& options) : scene_(scene), options_(options) {}

    bool isReadBy(const scene::Program& program) {
        return std::ranges::any_of(
            program.stages, [&](const scene::StageFile& each) { return isIn(scene_.files[each.file].path); });
    }

  private:
    bool isIn(const std::filesystem::path& file) {
        if (file.empty()) return false;
        const auto [known, isNew] = searched_.try_emplace(file, false);
        if (isNew) known->second = search(file);
        return known->second;
    }

    bool search(const std::filesystem::path& file) {
        const auto bytes = image::readFile(file, {file.generic_string(), {}}, kLargestSource);
        if (!bytes) return false;
        const std::string_view text = base::asText(*bytes);
        return text.find("Timer") != std::string_view::npos ||
               std::ranges::any_of(includedFiles(text, file, scene_, options_, listings_),
                                   [&](const std::filesystem::path& each) { return isIn(each); });
    }

    const scene::Scene& scene_;
    const RenderOptions& options_;
    scene::FolderListings listings_;
    std::map<std::filesystem::path, bool> searched_;  ///< whether the word is in it
};

}  // namespace

int mostDifferentFrames(const std::filesystem::path& path, const RenderOptions& options, int frames,
                        double framesPerSecond, int most) {
    most = std::min(most, frames);
    Stats stats;
    const Result<InterpretedScene> interpreted = interpretFile(path, options, stats);
    if (!interpreted || hasError(interpreted.diagnostics)) return 1;
    const scene::Scene& scene = interpreted->scene;
    if (!scene.once.empty() || !scene.steps.empty()) return 1;
    if (!options.skip || interpreted->changesWithTime()) return most;
    std::set<double> periods;
    TimerSearch search(scene, options);
    scene::List<bool, scene::Program> readsTimer;
    readsTimer.reserve(scene.programs.size());
    for (const scene::Program& each : scene.programs) readsTimer.push_back(search.isReadBy(each));
    scene.frame.visitDraws([&](const scene::Draw& draw, const auto&) {
        if (draw.program && readsTimer[draw.program]) periods.insert(draw.timerPeriod);
    });
    std::set<std::vector<float>> moments;
    for (int i = 0; i < frames && static_cast<int>(moments.size()) < most; ++i) {
        std::vector<float> moment;
        moment.reserve(periods.size());
        for (const double period : periods)
            moment.push_back(static_cast<float>(timerAt(options.time + i / framesPerSecond, period)));
        moments.insert(std::move(moment));
    }
    return static_cast<int>(moments.size());
}

Subject subjectOf(const Diagnostic& remark) {
    return {remark.id, remark.place.file, remark.place.line, remark.place.column};
}

Diagnostics joined(const std::vector<AnimationRemarks>& parts) {
    std::map<int, Diagnostics> ofFrames;
    Diagnostics all;
    std::set<std::string> lines;
    for (const AnimationRemarks& part : parts) {
        for (const Diagnostic& each : part.general)
            if (lines.insert(toString(each)).second) all.push_back(each);
        for (const auto& [frame, remarks] : part.ofFrames) append(ofFrames[frame], remarks);
    }
    std::map<Subject, int> firstFrames;
    for (auto& [frame, remarks] : ofFrames) {
        for (const Diagnostic& each : remarks) {
            if (firstFrames.try_emplace(subjectOf(each), frame).first->second == frame &&
                lines.insert(toString(each)).second)
                all.push_back(each);
        }
        if (hasError(remarks)) break;
    }
    return all;
}

}  // namespace glibra::render
