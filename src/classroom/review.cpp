#include "classroom/review.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "base/contained.h"
#include "base/whole_file.h"
#include "classroom/likeness.h"
#include "image/compare/flip.h"
#include "image/compare/structure.h"
#include "image/format.h"
#include "image/read.h"
#include "render/scene_renderer.h"
#include "scene/file_lookup.h"
#include "suite/run/exercise_check.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t kMostFiles = 200;         // of a submission
constexpr std::size_t kMostCalls = 10'000;      // of a submission
constexpr std::size_t kMostGivenFiles = 2'000;  // of a template
constexpr std::size_t kMostGivenTokens = 1'000'000;
constexpr std::uint64_t kLargestPicture = std::uint64_t{1} << 30;

std::optional<std::string> textOf(const base::Descriptor& file) {
    std::optional<std::string> text = base::textIn(file, kLargestSource);
    if (text && text->find('\0') != std::string::npos) text.reset();
    return text;
}

/// The shaders of one scene, each read once.
class Sources {
  public:
    Sources(const scene::Scene& scene, const RenderOptions& options)
        : scene_(scene), options_{options.libraryRoots, options.within} {
        const scene::SearchFolders folders = scene::searchFolders(scene.path, options_);
        readable_ = scene::shownRoots(folders);
        if (!options.within.empty()) {
            readable_.add(options.within);
            own_.add(options.within);
        }
    }

    /// The uniforms of a stage and of the files that it includes.
    std::vector<DeclaredUniform> uniformsOf(const scene::FileReference& file) {
        std::vector<DeclaredUniform> uniforms;
        std::set<std::string> seen;
        std::vector<std::pair<std::string, std::optional<std::string>>> open;  // path, and text if it has one
        if (!file.path.empty()) open.emplace_back(file.path.string(), file.text);
        while (!open.empty() && seen.size() < kMostFiles) {
            const auto [path, given] = std::move(open.back());
            open.pop_back();
            const std::string key = given ? path + ":" + std::to_string(file.place.line) : path;
            if (!seen.insert(key).second) continue;
            const std::optional<std::string> text = given ? given : textOf(opened(path));
            if (!text) {
                leaveOut(path, "cannot be read as text");
                continue;
            }
            for (DeclaredUniform& each : declaredUniforms(*text)) uniforms.push_back(std::move(each));
            for (const std::string& each : includedNames(*text)) {
                const scene::FileReference found =
                    scene::findInclude(each, path, scene_.path, options_, listings_);
                if (!found.path.empty()) open.emplace_back(found.path.string(), std::nullopt);
            }
            compare(key, path, *text);
        }
        if (!open.empty()) leaveOut({}, fmt::format("files after the first {} of a stage", kMostFiles));
        return uniforms;
    }

    /// Keeps the names of the functions that a stage calls.
    void addCalls(glsl::Stage stage, const scene::FileReference& file) {
        if (file.path.empty()) return;
        const std::optional<std::string> text = file.text ? file.text : textOf(opened(file.path));
        if (!text) return;
        const auto include = [this](std::string_view name, std::string_view includingPath) {
            return included(name, includingPath);
        };
        for (std::string& each : calledFunctions({stage, file.path.string(), *text}, include))
            if (calls_.size() < kMostCalls) calls_.insert(std::move(each));
    }

    void takeInto(Review& review) {
        review.files = std::move(files_);
        review.notCompared = std::move(notCompared_);
        review.calls.assign(calls_.begin(), calls_.end());
    }

  private:
    [[nodiscard]] base::Descriptor opened(const fs::path& path) const {
        // What the reference reads was chosen by the teacher.
        if (options_.within.empty() && !readable_.contains(path))
            return base::openBeneath(path.parent_path().empty() ? fs::path(".") : path.parent_path(),
                                     path.filename());
        return readable_.open(path);
    }

    std::optional<glsl::IncludedFile> included(std::string_view name, std::string_view includingPath) {
        const scene::FileReference found =
            scene::findInclude(name, includingPath, scene_.path, options_, listings_);
        std::optional<std::string> text = found.path.empty() ? std::nullopt : textOf(opened(found.path));
        if (!text) return std::nullopt;
        return glsl::IncludedFile{found.path.string(), std::move(*text)};
    }

    /// Keeps the tokens of a text that belongs to the submission.
    void compare(const std::string& key, const std::string& path, const std::string& text) {
        if (!compared_.insert(key).second) return;
        if (!options_.within.empty() && !own_.contains(path)) return leaveOut(path, "is of the library");
        if (files_.size() >= kMostFiles)
            return leaveOut({}, fmt::format("files after the first {}", kMostFiles));
        const std::size_t left = kMostTokens - count_;
        files_.push_back({path, comparableTokens(text, left + 1)});
        if (std::vector<SourceToken>& tokens = files_.back().tokens; tokens.size() > left) {
            tokens.resize(left);
            leaveOut(path, fmt::format("after its first {} tokens", left));
        }
        count_ += files_.back().tokens.size();
    }

    /// Remembers what is not compared, each once.
    void leaveOut(const fs::path& path, const std::string& why) {
        std::string text = path.empty() ? why : fmt::format("'{}' {}", path.filename().string(), why);
        if (notCompared_.size() < kMostFiles && std::ranges::find(notCompared_, text) == notCompared_.end())
            notCompared_.push_back(std::move(text));
    }

    const scene::Scene& scene_;
    scene::InterpretOptions options_;
    scene::FolderListings listings_;
    base::Roots readable_, own_;
    std::set<std::string> compared_, calls_;
    std::vector<SourceFile> files_;
    std::vector<std::string> notCompared_;
    std::size_t count_ = 0;  ///< of tokens
};

/// The sliders of a scene: what a window shows for it.
std::vector<RangedUniform> rangesOf(const scene::Scene& scene) {
    std::vector<RangedUniform> ranges;
    const auto add = [&](const std::string& name, glib::UniformForm form, const std::vector<double>& values) {
        if (form == glib::UniformForm::range && values.size() >= 2 && ranges.size() < kMostCalls)
            ranges.push_back({name, values.front(), values.back()});
    };
    for (const scene::Program& program : scene.programs)
        for (const glib::UniformSpec& each : program.uniforms) add(each.tag, each.form, each.values);
    for (const scene::UniformSet& set : scene.uniformSets)
        for (const glib::UniformSpec& each : set.values) add(each.tag, each.form, each.values);
    for (const scene::Variable& each : scene.variables) add(each.name, each.form, each.written);
    return ranges;
}

void reviewScene(const ReviewTask& task, Review& result) {
    render::Stats stats;
    const Result<render::InterpretedScene> read = render::interpretFile(task.scene, task.options, stats);
    if (!read) {
        result.notCompared.emplace_back("everything, because the scene cannot be read");
        return;
    }
    const scene::Scene& scene = read->scene;
    Sources sources(scene, task.options);
    for (const scene::Program& program : scene.programs) {
        UsedProgram used{program.name, {}, {}};
        for (const scene::StageFile& stage : program.stages) {
            used.stages.emplace_back(stageName(stage.stage));
            for (DeclaredUniform& each : sources.uniformsOf(scene.files[stage.file]))
                used.uniforms.push_back(std::move(each));
            sources.addCalls(stage.stage, scene.files[stage.file]);
        }
        std::ranges::sort(used.uniforms);
        used.uniforms.erase(std::unique(used.uniforms.begin(), used.uniforms.end()), used.uniforms.end());
        result.programs.push_back(std::move(used));
    }
    sources.takeInto(result);
    result.ranges = rangesOf(scene);
}

void addGivenFile(const fs::path& path, std::size_t& tokens, Review& result) {
    if (result.files.size() >= kMostGivenFiles || tokens >= kMostGivenTokens) return;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const std::optional<std::string> text = textOf(base::openBeneath(folder, path.filename()));
    if (!text) return;
    result.files.push_back({path.string(), comparableTokens(*text)});
    tokens += result.files.back().tokens.size();
}

void readGivenCode(const ReviewTask& task, Review& result) {
    std::size_t tokens = 0;
    for (const fs::path& source : task.sources) {
        std::error_code failure;
        if (!fs::is_directory(source, failure)) {
            addGivenFile(source, tokens, result);
            continue;
        }
        fs::recursive_directory_iterator each(source, fs::directory_options::skip_permission_denied, failure);
        for (; !failure && each != fs::recursive_directory_iterator(); each.increment(failure))
            if (each->symlink_status(failure).type() == fs::file_type::regular)
                addGivenFile(each->path(), tokens, result);
    }
}

/// A picture that another worker wrote. A link, or a file that is no PNG picture, is none.
std::optional<image::Image> pictureOf(const fs::path& site, const std::string& name) {
    const auto bytes = base::bytesIn(base::openBeneath(site, name), kLargestPicture);
    if (!bytes || image::formatOf(*bytes) != image::Format::png) return std::nullopt;
    return image::decodeImage(*bytes, site / name).value;
}

void scorePicture(const ReviewTask& task, const std::pair<std::string, std::string>& pictures,
                  Review& result) {
    const std::optional<image::Image> expected = pictureOf(task.site, pictures.first);
    const std::optional<image::Image> got = pictureOf(task.site, pictures.second);
    result.showNothing.push_back(got && showsNothing(*got));
    std::optional<Score>& score = result.scores.emplace_back();
    if (expected && got)
        score = Score{image::flip(*expected, *got, {.threads = 1}).mean,
                      image::structure(*expected, *got).difference, likeness(*expected, *got),
                      suite::whyUnsolved(task.has, *expected, *got)};
}

/// How much a submission's own pictures differ that differ in one value.
std::optional<double> reactionTo(const ReviewTask& task, const Slider& slider,
                                 const std::function<void()>& scored) {
    double sum = 0;
    std::size_t count = 0;
    for (const auto& [one, other] : slider.pairs) {
        const std::optional<image::Image> a = pictureOf(task.site, task.pictures.at(one).second);
        const std::optional<image::Image> b = pictureOf(task.site, task.pictures.at(other).second);
        if (scored) scored();
        if (!a || !b) continue;
        sum += reaction(*a, *b);
        ++count;
    }
    return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

}  // namespace

Review review(const ReviewTask& task, const std::function<void()>& scored) {
    Review result;
    if (!task.scene.empty()) reviewScene(task, result);
    readGivenCode(task, result);
    for (const auto& each : task.pictures) {
        scorePicture(task, each, result);
        if (scored) scored();
    }
    for (const Slider& each : task.sliders) result.reactions.push_back(reactionTo(task, each, scored));
    return result;
}

std::string toText(const Review& review) {
    Json json = {{"programs", Json::array()},
                 {"files", Json::array()},
                 {"scores", Json::array()},
                 {"notCompared", review.notCompared}};
    for (const UsedProgram& each : review.programs) {
        Json uniforms = Json::array();
        for (const DeclaredUniform& one : each.uniforms) uniforms.push_back({one.name, one.type});
        json["programs"].push_back(
            {{"name", each.name}, {"stages", each.stages}, {"uniforms", std::move(uniforms)}});
    }
    for (const SourceFile& each : review.files) {
        Json codes = Json::array(), lines = Json::array();
        for (const SourceToken& one : each.tokens) {
            codes.push_back(one.code);
            lines.push_back(one.line);
        }
        json["files"].push_back(
            {{"path", each.path}, {"codes", std::move(codes)}, {"lines", std::move(lines)}});
    }
    for (const std::optional<Score>& each : review.scores)
        json["scores"].push_back(each ? Json{each->flip, each->structure, each->likeness, each->unsolved}
                                      : Json(nullptr));
    json["calls"] = review.calls;
    json["ranges"] = Json::array();
    for (const RangedUniform& each : review.ranges)
        json["ranges"].push_back({each.name, each.least, each.largest});
    json["showNothing"] = review.showNothing;
    json["reactions"] = Json::array();
    for (const std::optional<double>& each : review.reactions)
        json["reactions"].push_back(each ? Json(*each) : Json(nullptr));
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<Review> parseReview(std::string_view text) try {
    const Json json = Json::parse(text);
    Review result;
    for (const Json& each : json.at("programs")) {
        UsedProgram used{
            each.at("name").get<std::string>(), each.at("stages").get<std::vector<std::string>>(), {}};
        for (const Json& one : each.at("uniforms"))
            used.uniforms.push_back({one.at(0).get<std::string>(), one.at(1).get<std::string>()});
        result.programs.push_back(std::move(used));
    }
    for (const Json& each : json.at("files")) {
        SourceFile file{each.at("path").get<std::string>(), {}};
        const Json& codes = each.at("codes");
        const Json& lines = each.at("lines");
        for (std::size_t i = 0; i < codes.size(); ++i)
            file.tokens.push_back({codes.at(i).get<std::uint32_t>(), lines.at(i).get<std::int32_t>()});
        result.files.push_back(std::move(file));
    }
    result.notCompared = json.at("notCompared").get<std::vector<std::string>>();
    for (const Json& each : json.at("scores")) {
        std::optional<Score>& score = result.scores.emplace_back();
        if (each.is_null()) continue;
        score = Score{each.at(0).get<double>(), each.at(1).get<double>(), each.at(2).get<double>(),
                      each.at(3).get<std::string>()};
        if (!std::isfinite(score->flip) || !std::isfinite(score->structure) ||
            !std::isfinite(score->likeness))
            return std::nullopt;
    }
    result.calls = json.at("calls").get<std::vector<std::string>>();
    for (const Json& each : json.at("ranges"))
        if (each.at(1).is_number() && each.at(2).is_number())
            result.ranges.push_back(
                {each.at(0).get<std::string>(), each.at(1).get<double>(), each.at(2).get<double>()});
    result.showNothing = json.at("showNothing").get<std::vector<bool>>();
    for (const Json& each : json.at("reactions")) {
        result.reactions.push_back(each.is_null() ? std::nullopt : std::optional(each.get<double>()));
        if (result.reactions.back() && !std::isfinite(*result.reactions.back())) return std::nullopt;
    }
    return result;
} catch (const Json::exception&) {
    return std::nullopt;
}

}  // namespace glibra::classroom
