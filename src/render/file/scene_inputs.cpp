#include "render/file/scene_inputs.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>

#include "base/files.h"
#include "image/file.h"
#include "render/draw/frame.h"
#include "render/scene_renderer.h"
#include "render/simulation/simulation.h"
#include "render/stats.h"

namespace glibra::render {

namespace fs = std::filesystem;

namespace {

/// Steps that are interpreted to find what they read.
constexpr std::int64_t kMostSteps = 2'000;

/// True if a file may be read at some times and not at others. Everything else is declared outside of `When`.
bool mayChooseFiles(const scene::Interpretation& source) {
    constexpr std::array kChoosing{glib::CommandId::obj, glib::CommandId::wireObj, glib::CommandId::objAdj,
                                   glib::CommandId::objPatch, glib::CommandId::include};
    for (const glib::Script* script : source.scripts())
        for (const glib::Command& command : script->commands)
            if (std::ranges::find(kChoosing, command.id) != kChoosing.end()) return true;
    return false;
}

/// True if another time may read other files.
bool isTimed(const InterpretedScene& interpreted) {
    const auto& steps = interpreted.scene.steps;
    return interpreted.source &&
           (interpreted.changesWithTime() ||
            std::ranges::any_of(steps, [](const auto& each) { return each.dependsOnTick; }));
}

/// Interprets the scene for the picture at `time`, so that its list of files has those of that time. False if
/// steps were left out.
bool visitMoments(InterpretedScene& interpreted, double time) {
    if (!isTimed(interpreted) || !mayChooseFiles(*interpreted.source)) return true;
    std::set<double> times{time};
    for (const scene::Check& each : interpreted.scene.checks)
        for (const double seconds : each.times()) times.insert(seconds);
    scene::FrameInputs inputs = interpreted.inputs;
    bool isWhole = true;
    for (const double each : times) {
        const std::size_t blocks = interpreted.scene.steps.size();
        for (std::size_t block = 0; block < blocks; ++block) {
            const double rate = interpreted.scene.steps[block].rate;
            const std::int64_t count = stepsAt(each, rate);
            isWhole &= count <= kMostSteps;
            for (std::int64_t tick = 0; tick < std::min(count, kMostSteps); ++tick) {
                inputs.time = static_cast<double>(tick) / rate;
                inputs.ticks.assign(blocks, 0);
                inputs.ticks[block] = tick;
                inputs.sinceStepBefore = 1 / rate;
                interpreted.scene = interpreted.source->at(inputs);
                if (interpreted.scene.steps.size() != blocks) return false;
            }
        }
        inputs = interpreted.inputs;
        inputs.time = each;
        interpreted.scene = interpreted.source->at(inputs);
    }
    return isWhole;
}

}  // namespace

std::vector<fs::path> includedFiles(std::string_view text, const fs::path& file, const scene::Scene& scene,
                                    const RenderOptions& options, scene::FolderListings& listings) {
    constexpr std::string_view kInclude = "#include";
    std::vector<fs::path> files;
    for (std::size_t at = text.find(kInclude); at != std::string_view::npos;
         at = text.find(kInclude, at + 1)) {
        const std::string_view rest = text.substr(at, text.find('\n', at) - at);
        const std::size_t begin = rest.find_first_of("\"<");
        if (begin == std::string_view::npos) continue;
        const std::size_t end = rest.find_first_of("\">", begin + 1);
        if (end == std::string_view::npos) continue;
        scene::FileReference found =
            scene::findInclude(rest.substr(begin + 1, end - begin - 1), file.generic_string(), scene.path,
                               {options.libraryRoots, options.within}, listings);
        if (!found.path.empty()) files.push_back(std::move(found.path));
    }
    return files;
}

ReadByScene filesReadBy(const fs::path& path, const RenderOptions& options) {
    std::set<fs::path> files;
    if (!options.sceneText) files.insert(path);
    Stats stats;
    Result<InterpretedScene> interpreted = interpretFile(path, options, stats);
    if (!interpreted) return {{files.begin(), files.end()}};
    ReadByScene read;
    read.changesWithTime = isTimed(*interpreted);
    read.isWhole = visitMoments(*interpreted, options.time);
    const scene::Scene& scene = interpreted->scene;
    if (interpreted->source)
        for (const glib::Script* each : interpreted->source->scripts())
            if (each->path != path) files.insert(each->path);
    scene::FolderListings listings;
    std::vector<std::pair<fs::path, std::string>> open;  // shaders whose text is to be searched
    const auto addShader = [&](const fs::path& file) {
        if (file.empty() || !files.insert(file).second) return;
        const auto bytes = image::readFile(file, {file.generic_string(), {}}, kLargestSource);
        if (bytes) open.emplace_back(file, base::asText(*bytes));
    };
    for (const scene::Program& program : scene.programs)
        for (const scene::StageFile& each : program.stages) {
            const scene::FileReference& file = scene.files[each.file];
            if (file.text)
                open.emplace_back(file.path, *file.text);
            else
                addShader(file.path);
        }
    for (const auto& [name, each] : scene.glslTexts) open.emplace_back(each.path, *each.text);
    while (!open.empty()) {
        const auto [file, text] = std::move(open.back());
        open.pop_back();
        for (const fs::path& each : includedFiles(text, file, scene, options, listings)) addShader(each);
    }
    for (const scene::FileReference& each : scene.files)
        if (!each.path.empty()) files.insert(each.path);
    read.files.assign(files.begin(), files.end());
    return read;
}

// ---- Animations

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
