#include "classroom/review.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "base/contained.h"
#include "base/files.h"
#include "base/packed.h"
#include "classroom/effect.h"
#include "classroom/hand_in.h"
#include "classroom/likeness.h"
#include "classroom/reached_code.h"
#include "image/compare/compare.h"
#include "image/compare/flip.h"
#include "image/format.h"
#include "image/read.h"
#include "render/scene_renderer.h"
#include "scene/file_lookup.h"
#include "scene/primitives.h"
#include "suite/golden/hash_list.h"
#include "suite/run/exercise_check.h"

namespace glibra::classroom {

void eachMember(auto& packed, base::Is<DeclaredUniform> auto& of) {
    packed(of.name, of.type);
}
void eachMember(auto& packed, base::Is<UsedProgram> auto& of) {
    packed(of.name, of.stages, of.uniforms, of.idle);
}
void eachMember(auto& packed, base::Is<SourceToken> auto& of) {
    packed(of.code, of.line, of.file);
}
void eachMember(auto& packed, base::Is<SourceFile> auto& of) {
    packed(of.path, of.tokens, of.others);
}
void eachMember(auto& packed, base::Is<Score> auto& of) {
    packed(of.flip, of.structure, of.likeness, of.effect, of.kept, of.unsolved);
}
void eachMember(auto& packed, base::Is<Change> auto& of) {
    packed(of.mean, of.strength, of.isOtherwise);
}
void eachMember(auto& packed, base::Is<RangedUniform> auto& of) {
    packed(of.name, of.least, of.largest);
}
void eachMember(auto& packed, base::Is<ReadPicture> auto& of) {
    packed(of.name, of.digest, of.isLikeReference);
}
void eachMember(auto& packed, base::Is<Review> auto& of) {
    packed(of.programs, of.files, of.functions, of.notCompared, of.scores, of.showNothing, of.reactions);
    packed(of.ranges, of.calls, of.readPictures, of.digest, of.small);
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 200;         // of a submission
constexpr std::size_t kMostCalls = 10'000;      // of a submission
constexpr std::size_t kMostRuns = 2'000;        // of a submission
constexpr std::size_t kMostGivenFiles = 2'000;  // of a template
constexpr std::size_t kMostGivenTokens = 1'000'000;
constexpr std::uint64_t kLargestPicture = std::uint64_t{1} << 30;
constexpr std::size_t kMostReadPictures = 50;  // of a submission
constexpr std::uint64_t kLargestReadPicture = std::uint64_t{32} << 20U;

std::optional<std::string> textOf(const system::File& file) {
    std::optional<std::string> text = base::textIn(file, kLargestSource);
    if (text && text->find('\0') != std::string::npos) text.reset();
    return text;
}

/// The shaders of one scene, each read once.
class Sources {
  public:
    Sources(const scene::Scene& scene, const RenderOptions& options, const std::set<std::uint64_t>& given)
        : scene_(scene), options_{options.libraryRoots, options.within} {
        rule_.given = given;
        if (!options.within.empty())
            rule_.isOwn = [this](const std::string& path) { return own_.contains(path); };
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
        if (!file.path.empty()) open.emplace_back(file.path.generic_string(), file.text);
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
                if (!found.path.empty()) open.emplace_back(found.path.generic_string(), std::nullopt);
            }
        }
        if (!open.empty()) leaveOut({}, fmt::format("files after the first {} of a stage", kMostFiles));
        return uniforms;
    }

    /// Keeps the code that a stage runs, and if it `counts`, the names of the functions that this calls.
    /// False for a stage without code, and for a geometry stage that emits nothing.
    bool addCode(glsl::Stage stage, const scene::FileReference& file, bool counts) {
        if (file.path.empty()) return false;
        const std::optional<std::string> text = file.text ? file.text : textOf(opened(file.path));
        if (!text) return false;
        const auto include = [this](std::string_view name, std::string_view includingPath) {
            return included(name, includingPath);
        };
        ReachedCode code = reachedCode({stage, file.path.generic_string(), *text}, include, rule_);
        if (!code.isWhole) leaveOut(file.path, "after what the preprocessor reads of it");
        for (SourceFile& each : code.runs) compare(std::move(each));
        if (options_.within.empty())
            functions_.insert(functions_.end(), code.functions.begin(), code.functions.end());
        const bool emits = std::ranges::binary_search(code.calls, "EmitVertex") ||
                           std::ranges::binary_search(code.calls, "EmitStreamVertex");
        for (const std::string& each : code.calls)
            if (counts && calls_.size() < kMostCalls) calls_.insert(each);
        return stage != glsl::Stage::geometry || emits;
    }

    void takeInto(Review& review) {
        review.files = std::move(files_);
        review.functions = std::move(functions_);
        review.notCompared = std::move(notCompared_);
        review.calls.assign(calls_.begin(), calls_.end());
    }

  private:
    [[nodiscard]] system::File opened(const fs::path& path) const {
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
        return glsl::IncludedFile{found.path.generic_string(), std::move(*text)};
    }

    /// Keeps code of the submission, each once: stages may share it.
    void compare(SourceFile run) {
        if (!options_.within.empty() && !own_.contains(run.path))
            return leaveOut(run.path, "is of the library");
        if (!compared_.insert({run.path, run.tokens}).second) return;
        if (files_.size() >= kMostRuns)
            return leaveOut({}, fmt::format("code after its first {} pieces", kMostRuns));
        const std::size_t left = kMostTokens - count_;
        if (run.tokens.size() > left) {
            run.tokens.resize(left);
            leaveOut(run.path, fmt::format("after its first {} tokens", left));
        }
        count_ += run.tokens.size();
        files_.push_back(std::move(run));
    }

    /// Remembers what is not compared, each once.
    void leaveOut(const fs::path& path, const std::string& why) {
        std::string text = path.empty() ? why : fmt::format("'{}' {}", path.filename().generic_string(), why);
        if (notCompared_.size() < kMostFiles && std::ranges::find(notCompared_, text) == notCompared_.end())
            notCompared_.push_back(std::move(text));
    }

    const scene::Scene& scene_;
    scene::InterpretOptions options_;
    scene::FolderListings listings_;
    base::Roots readable_, own_;
    std::set<std::pair<std::string, std::vector<SourceToken>>> compared_;
    std::set<std::string> calls_;
    std::vector<SourceFile> files_;
    InlineRule rule_;
    std::vector<std::uint64_t> functions_;  ///< of the reference
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

void addGivenFile(const fs::path& path, std::size_t& tokens, Review& result) {
    if (result.files.size() >= kMostGivenFiles || tokens >= kMostGivenTokens) return;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const std::optional<std::string> text = textOf(base::openBeneath(folder, path.filename()));
    if (!text) return;
    // As it is written, and as a stage of it would run: copies of both are no copies.
    result.files.push_back({path.generic_string(), comparableTokens(*text)});
    ReachedCode code = reachedCode({glsl::Stage::fragment, path.generic_string(), *text});
    for (SourceFile& each : code.runs) result.files.push_back(std::move(each));
    result.functions.insert(result.functions.end(), code.functions.begin(), code.functions.end());
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

/// The pictures of one moment, reduced; empty where one cannot be read.
struct SmallPictures {
    std::optional<Colors> reference, own;
};

SmallPictures scorePicture(const ReviewTask& task, const std::pair<std::string, std::string>& pictures,
                           Review& result) {
    const std::optional<image::Image> expected = pictureOf(task.site, pictures.first);
    const std::optional<image::Image> got = pictureOf(task.site, pictures.second);
    result.showNothing.push_back(got && showsNothing(*got));
    std::optional<Score>& score = result.scores.emplace_back();
    if (expected && got)
        score = Score{image::flip(*expected, *got, {.threads = 1}).mean,
                      image::structure(*expected, *got).difference,
                      likeness(*expected, *got),
                      {},
                      1,
                      suite::whyUnsolved(task.has, *expected, *got)};
    return {expected ? std::optional(reduced(*expected)) : std::nullopt,
            got ? std::optional(reduced(*got)) : std::nullopt};
}

/// The effect between two moments; nothing if it cannot be measured.
std::optional<Effect> effectBetween(const std::vector<SmallPictures>& small, std::size_t one,
                                    std::size_t other) {
    const SmallPictures &a = small.at(one), &b = small.at(other);
    if (!a.reference || !b.reference || !a.own || !b.own) return std::nullopt;
    return effectOf(*a.reference, *b.reference, *a.own, *b.own);
}

/// Takes from each likeness what the effect does not have: what changes between its moment and that at which
/// the reference's picture differs most from it.
void compareEffects(const std::vector<SmallPictures>& small, Review& result) {
    for (std::size_t i = 0; i < small.size(); ++i) {
        if (!result.scores[i]) continue;
        std::size_t most = i;
        double largest = 0;
        for (std::size_t k = 0; k < small.size(); ++k) {
            if (!small[i].reference || !small[k].reference || !small[k].own) continue;
            const double difference = differenceOf(*small[i].reference, *small[k].reference);
            if (difference <= largest) continue;
            largest = difference;
            most = k;
        }
        const std::optional<Effect> effect = effectBetween(small, i, most);
        if (!effect) continue;
        Score& score = *result.scores[i];
        score.kept = keptLikeness(*effect);
        score.likeness *= score.kept;
        if (score.kept < 1) score.effect = effect->likeness;
    }
}

/// How a submission's own pictures change that differ in one value.
std::optional<Change> changeWith(const ReviewTask& task, const Slider& slider,
                                 const std::vector<SmallPictures>& small,
                                 const std::function<void()>& scored) {
    Change change;
    std::size_t count = 0, otherwise = 0;
    for (const auto& [one, other] : slider.pairs) {
        const std::optional<image::Image> a = pictureOf(task.site, task.pictures.at(one).second);
        const std::optional<image::Image> b = pictureOf(task.site, task.pictures.at(other).second);
        if (scored) scored();
        if (!a || !b) continue;
        const Reaction found = reaction(*a, *b);
        change.mean += found.mean;
        change.strength += found.strength;
        const std::optional<Effect> effect = effectBetween(small, one, other);
        otherwise += effect && changesOtherwise(*effect) ? 1 : 0;
        ++count;
    }
    if (count == 0) return std::nullopt;
    change.mean /= static_cast<double>(count);
    change.strength /= static_cast<double>(count);
    change.isOtherwise = 2 * otherwise > count;
    return change;
}

/// True for a part of one of the first pictures that the reference draws.
bool isPartOfReference(const ReviewTask& task, const image::Image& picture) {
    constexpr std::size_t kMostSearched = 12;
    for (std::size_t i = 0; i < std::min(task.pictures.size(), kMostSearched); ++i)
        if (const auto reference = pictureOf(task.site, task.pictures[i].first);
            reference && isCutFrom(*reference, picture))
            return true;
    return false;
}

/// Adds the pictures that a scene reads of its own folder.
void addReadPictures(const scene::Scene& scene, const ReviewTask& task,
                     const std::vector<SmallPictures>& small, Review& result) {
    base::Roots own;
    own.add(task.options.within.empty() ? fs::absolute(task.scene).parent_path() : task.options.within);
    for (const scene::Texture& texture : scene.textures) {
        const auto* source = std::get_if<scene::PictureSource>(&texture.source);
        if (!source) continue;
        for (const scene::FileIndex index : source->files) {
            const fs::path& path = scene.files[index].path;
            if (path.empty() || result.readPictures.size() >= kMostReadPictures) continue;
            const auto bytes = base::bytesIn(own.open(path), kLargestReadPicture);
            if (!bytes) continue;
            ReadPicture& read = result.readPictures.emplace_back();
            read.name = path.filename().generic_string();
            read.digest = suite::toText(suite::hashOf(*bytes));
            if (task.options.within.empty()) continue;  // the reference may look like itself
            const std::optional<image::Image> picture = image::decodeImage(*bytes, path).value;
            read.isLikeReference =
                picture && (std::ranges::any_of(small,
                                                [&](const SmallPictures& each) {
                                                    return each.reference &&
                                                           looksLike(*each.reference, *picture);
                                                }) ||
                            isPartOfReference(task, *picture));
        }
    }
}

/// The stages of programs that something is drawn or computed with, by the names of the programs.
using DrawnStages = std::set<std::pair<std::string, glsl::Stage>>;

void addDrawn(const scene::Scene& scene, DrawnStages& drawn) {
    const auto add = [&](scene::ProgramIndex index, bool isFill) {
        if (!index) return;
        const scene::Program& program = scene.programs[index];
        for (const scene::StageFile& each : program.stages)
            if (program.hasStage(each.stage, isFill)) drawn.insert({program.name, each.stage});
    };
    const auto addAll = [&](const scene::NodeList& nodes) {
        nodes.visitDraws([&](const scene::Draw& draw, const scene::Pass&) {
            const bool isThere = draw.instances > 0 || draw.instancesFrom;
            if (isThere && !scene::drawsNothing(scene.shapes[draw.shape])) add(draw.program, draw.isFill);
        });
        for (const scene::Dispatch& each : nodes.dispatches) add(each.program, false);
    };
    addAll(scene.frame);
    for (const scene::OnceBlock& each : scene.once) addAll(each.nodes);
    for (const scene::StepBlock& each : scene.steps) addAll(each.nodes);
}

/// What the pictures of a scene are drawn with. Which statements run depends on the time and on values.
DrawnStages drawnStages(const ReviewTask& task, const scene::Scene& first) {
    DrawnStages drawn;
    addDrawn(first, drawn);
    std::size_t all = 0;
    for (const scene::Program& each : first.programs) all += each.stages.size();
    for (const RenderOptions& options : task.others) {
        if (drawn.size() >= all) break;
        render::Stats stats;
        if (const auto read = render::interpretFile(task.scene, options, stats)) addDrawn(read->scene, drawn);
    }
    return drawn;
}

void reviewScene(const ReviewTask& task, const std::vector<SmallPictures>& small, Review& result) {
    render::Stats stats;
    const Result<render::InterpretedScene> read = render::interpretFile(task.scene, task.options, stats);
    if (!read) {
        result.notCompared.emplace_back("everything, because the scene cannot be read");
        return;
    }
    const scene::Scene& scene = read->scene;
    const DrawnStages drawn = drawnStages(task, scene);
    Sources sources(scene, task.options, task.givenFunctions);
    for (const scene::Program& program : scene.programs) {
        UsedProgram used{program.name, {}, {}};
        for (const scene::StageFile& stage : program.stages) {
            used.stages.emplace_back(glsl::stageName(stage.stage));
            for (DeclaredUniform& each : sources.uniformsOf(scene.files[stage.file]))
                used.uniforms.push_back(std::move(each));
            const bool runs = drawn.contains({program.name, stage.stage});
            if (!sources.addCode(stage.stage, scene.files[stage.file], runs) || !runs)
                used.idle.push_back(used.stages.back());
        }
        std::ranges::sort(used.uniforms);
        used.uniforms.erase(std::unique(used.uniforms.begin(), used.uniforms.end()), used.uniforms.end());
        result.programs.push_back(std::move(used));
    }
    sources.takeInto(result);
    result.ranges = rangesOf(scene);
    addReadPictures(scene, task, small, result);
}

}  // namespace

Review review(const ReviewTask& task, const std::function<void()>& scored) {
    Review result;
    std::vector<SmallPictures> small;
    for (const auto& each : task.pictures) {
        small.push_back(scorePicture(task, each, result));
        if (scored) scored();
    }
    compareEffects(small, result);
    for (const Slider& each : task.sliders) result.reactions.push_back(changeWith(task, each, small, scored));
    if (!task.scene.empty()) reviewScene(task, small, result);
    readGivenCode(task, result);
    for (const std::string& each : task.shown) {
        const std::optional<image::Image> picture = pictureOf(task.site, each);
        result.small.push_back(picture ? smallPicture(*picture) : std::string());
        if (scored) scored();
    }
    if (task.handedIn.empty()) return result;
    std::vector<RenderOptions> pictures = task.others;
    pictures.push_back(task.options);
    result.digest = digestOfHandIn(task.handedIn, pictures);
    return result;
}

std::string toText(const Review& review) {
    return base::packed(review, base::PackedText::utf8);
}

std::optional<Review> parseReview(std::string_view text) {
    std::optional<Review> result = base::unpacked<Review>(text);
    if (!result) return std::nullopt;
    const auto areFinite = [](auto... numbers) { return (std::isfinite(numbers) && ...); };
    for (const std::optional<Score>& each : result->scores)
        if (each && !(areFinite(each->flip, each->structure, each->likeness, each->kept) &&
                      areFinite(each->effect.value_or(0))))
            return std::nullopt;
    for (const std::optional<Change>& each : result->reactions)
        if (each && !areFinite(each->mean, each->strength)) return std::nullopt;
    std::erase_if(result->ranges,
                  [&](const RangedUniform& each) { return !areFinite(each.least, each.largest); });
    for (std::string& each : result->small)
        if (!isSmallPicture(each)) each.clear();
    return result;
}

}  // namespace glibra::classroom
