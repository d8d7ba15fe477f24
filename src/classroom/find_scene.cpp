#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <system_error>

#include "classroom/archive.h"
#include "classroom/submissions.h"
#include "glib/text.h"
#include "suite/file/selection.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

/// What is looked at in one submission. A student may hand in a whole disk.
constexpr int kDeepest = 8;
constexpr std::size_t kMostSeen = 20'000;

/// What a folder has, relative to it, in the order of the paths.
struct Contents {
    std::vector<fs::path> scenes;
    std::vector<fs::path> archives;
    std::vector<fs::path> misnamed;  ///< "x.glib.txt"
};

std::string namesOf(const std::vector<const fs::path*>& files) {
    constexpr std::size_t kMostNames = 6;
    std::string names;
    for (std::size_t i = 0; i < std::min(files.size(), kMostNames); ++i)
        names += fmt::format("{}'{}'", i == 0 ? "" : ", ", files[i]->generic_string());
    return names + (files.size() > kMostNames ? ", ..." : "");
}

std::string namesOf(std::span<const fs::path> files) {
    std::vector<const fs::path*> all;
    for (const fs::path& each : files) all.push_back(&each);
    return namesOf(all);
}

/// `problem` says why the contents may not be all: there are more entries than are looked at, or a folder
/// cannot be listed.
Contents contentsOf(const fs::path& folder, std::string& problem, bool& isUnlisted) {
    Contents found;
    std::error_code failure;
    std::size_t seen = 0;
    fs::recursive_directory_iterator each(folder, failure);
    for (; !failure && each != fs::recursive_directory_iterator(); each.increment(failure)) {
        if (++seen > kMostSeen) {
            problem = fmt::format("the folder has more than {} files and folders", kMostSeen);
            break;
        }
        std::error_code ignored;
        const fs::file_type type = each->symlink_status(ignored).type();
        const fs::path& path = each->path();
        if (path.filename().generic_string().starts_with('.')) {
            if (type == fs::file_type::directory) each.disable_recursion_pending();
            continue;
        }
        if (type == fs::file_type::directory && each.depth() >= kDeepest) each.disable_recursion_pending();
        if (type != fs::file_type::regular && type != fs::file_type::symlink) continue;
        if (glib::sameWord(path.extension().generic_string(), ".glib"))
            found.scenes.push_back(path.lexically_relative(folder));
        else if (type == fs::file_type::regular && isArchive(path))
            found.archives.push_back(path.lexically_relative(folder));
        else if (glib::sameWord(path.stem().extension().generic_string(), ".glib"))
            found.misnamed.push_back(path.lexically_relative(folder));
    }
    isUnlisted = bool(failure);
    if (isUnlisted)
        problem = fmt::format("the folder, or one in it, cannot be listed: {}", failure.message());
    for (std::vector<fs::path>* list : {&found.scenes, &found.archives, &found.misnamed})
        std::ranges::sort(*list);
    return found;
}

std::string withoutScene(const Contents& contents) {
    std::string text = "the folder has no scene: expected a file whose name ends with '.glib'";
    if (!contents.misnamed.empty())
        text += fmt::format("; found {}, which {} another ending", namesOf(contents.misnamed),
                            contents.misnamed.size() == 1 ? "has" : "have");
    if (!contents.archives.empty())
        text += fmt::format("; found {}, which {} not unpacked", namesOf(contents.archives),
                            contents.archives.size() == 1 ? "is" : "are");
    return text;
}

bool fitsPattern(const std::string& pattern, const fs::path& scene) {
    const bool wholePath = pattern.find('/') != std::string::npos;
    return suite::fits(pattern, wholePath ? scene.generic_string() : scene.filename().generic_string());
}

}  // namespace

ChosenScene chooseScene(std::span<const fs::path> scenes, const Submission& submission,
                        const SubmissionOptions& options) {
    if (scenes.empty()) return {0, withoutScene({})};
    std::vector<const fs::path*> left;
    for (const fs::path& each : scenes) left.push_back(&each);
    const auto fitting = [&](const std::string& pattern) {
        std::vector<const fs::path*> fit;
        for (const fs::path& each : scenes)
            if (fitsPattern(pattern, each)) fit.push_back(&each);
        return fit;
    };
    for (const std::string& each : identitiesOf(submission)) {
        const auto own = options.sceneOf.find(each);
        if (own == options.sceneOf.end()) continue;
        const std::vector<const fs::path*> fit = fitting(own->second);
        if (fit.empty())
            return {0, fmt::format("no scene fits --scene-of '{}={}'; found {}", own->first, own->second,
                                   namesOf(left))};
        left = fit;
        break;
    }
    if (left.size() == scenes.size() && left.size() > 1)
        for (const std::string& each : options.scenes)
            if (std::vector<const fs::path*> fit = fitting(each); !fit.empty()) {
                left = std::move(fit);
                break;
            }
    const auto chosen = [&](const fs::path* scene) {
        return ChosenScene{static_cast<std::size_t>(scene - scenes.data()), {}};
    };
    if (left.size() == 1) return chosen(left.front());
    const auto onlyOne = [&](const auto& fits) -> const fs::path* {
        const auto found = std::ranges::find_if(left, fits);
        return found != left.end() && std::none_of(std::next(found), left.end(), fits) ? *found : nullptr;
    };
    const std::string preferred = options.reference.filename().generic_string();
    if (const fs::path* one = onlyOne([&](const fs::path* each) { return each->filename() == preferred; }))
        return chosen(one);
    if (const fs::path* one = onlyOne([&](const fs::path* each) {
            return each->stem() == submission.name || each->stem() == submission.key;
        }))
        return chosen(one);
    const auto depth = [](const fs::path* each) { return std::distance(each->begin(), each->end()); };
    const auto least = depth(*std::ranges::min_element(
        left, [&](const fs::path* a, const fs::path* b) { return depth(a) < depth(b); }));
    if (const fs::path* one = onlyOne([&](const fs::path* each) { return depth(each) == least; }))
        return chosen(one);
    return {0, fmt::format("the folder has {} scenes: {}; expected one, or one named {}'{}.glib'; --scene "
                           "chooses",
                           left.size(), namesOf(left),
                           preferred.empty() ? "" : fmt::format("'{}' or ", preferred), submission.name)};
}

void findScene(Submission& submission, const SubmissionOptions& options) {
    const Contents found = contentsOf(submission.folder, submission.problem, submission.isUnlisted);
    if (!submission.problem.empty()) return;
    if (found.scenes.empty()) {
        // Platforms put the one zip file that was handed in into a folder.
        if (found.archives.size() == 1 && submission.parts.empty())
            submission.parts.push_back({submission.folder / found.archives.front(), {}});
        else
            submission.problem = withoutScene(found);
        return;
    }
    const ChosenScene chosen = chooseScene(found.scenes, submission, options);
    if (!chosen.problem.empty()) {
        submission.problem = chosen.problem;
        return;
    }
    const fs::path& scene = found.scenes[chosen.index];
    if (std::error_code failure; fs::is_symlink(submission.folder / scene, failure))
        submission.problem =
            fmt::format("the scene '{}' is a link; expected the file itself", scene.generic_string());
    else
        submission.scene = submission.folder / scene;
}

}  // namespace glibra::classroom
