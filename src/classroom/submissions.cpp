#include "classroom/submissions.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "glib/text.h"
#include "suite/file/glob.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

/// What is looked at in one submission. A student may hand in a whole disk.
constexpr int kDeepest = 8;
constexpr std::size_t kMostEntries = 20'000;

bool isHidden(const fs::path& path) {
    return path.filename().string().starts_with('.');
}

bool isScene(const fs::path& path) {
    return glib::sameWord(path.extension().string(), ".glib");
}

fs::file_type typeOf(const fs::directory_entry& entry) {
    std::error_code failure;
    return entry.symlink_status(failure).type();
}

/// The scenes below a folder, relative to it, in the order of their paths. `problem` says why they may not be
/// all: there are more entries than are looked at, or a folder cannot be listed.
std::vector<fs::path> scenesBelow(const fs::path& folder, std::string& problem, bool& isUnlisted) {
    std::vector<fs::path> scenes;
    std::error_code failure;
    std::size_t seen = 0;
    fs::recursive_directory_iterator each(folder, failure);
    for (; !failure && each != fs::recursive_directory_iterator(); each.increment(failure)) {
        if (++seen > kMostEntries) {
            problem = fmt::format("the folder has more than {} files and folders", kMostEntries);
            break;
        }
        const fs::file_type type = typeOf(*each);
        if (isHidden(each->path())) {
            if (type == fs::file_type::directory) each.disable_recursion_pending();
            continue;
        }
        if (type == fs::file_type::directory && each.depth() >= kDeepest) each.disable_recursion_pending();
        if ((type == fs::file_type::regular || type == fs::file_type::symlink) && isScene(each->path()))
            scenes.push_back(each->path().lexically_relative(folder));
    }
    isUnlisted = bool(failure);
    if (isUnlisted)
        problem = fmt::format("the folder, or one in it, cannot be listed: {}", failure.message());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

Submission fromFolder(const fs::path& folder, const SubmissionOptions& options) {
    Submission made{folder.filename().string(), folder, {}, {}};
    const std::vector<fs::path> scenes = scenesBelow(folder, made.problem, made.isUnlisted);
    const ChosenScene chosen = chooseScene(scenes, made.name, options);
    if (!made.problem.empty()) return made;
    if (!chosen.problem.empty())
        made.problem = chosen.problem;
    else if (std::error_code failure; fs::is_symlink(folder / scenes[chosen.index], failure))
        made.problem =
            fmt::format("the scene '{}' is a link; expected the file itself", scenes[chosen.index].string());
    else
        made.scene = folder / scenes[chosen.index];
    return made;
}

std::string namesOf(const std::vector<const fs::path*>& scenes) {
    constexpr std::size_t kMostNames = 6;
    std::string names;
    for (std::size_t i = 0; i < std::min(scenes.size(), kMostNames); ++i)
        names += fmt::format("{}'{}'", i == 0 ? "" : ", ", scenes[i]->string());
    return names + (scenes.size() > kMostNames ? ", ..." : "");
}

Diagnostic problem(const std::string& text) {
    return withoutId(Severity::error, text);
}

}  // namespace

ChosenScene chooseScene(std::span<const fs::path> scenes, const std::string& submission,
                        const SubmissionOptions& options) {
    if (scenes.empty()) return {0, "the folder has no scene: expected a file whose name ends with '.glib'"};
    const bool wholePath = options.scene.find('/') != std::string::npos;
    std::vector<const fs::path*> left;
    for (const fs::path& each : scenes)
        if (options.scene.empty() ||
            suite::fits(options.scene, wholePath ? each.generic_string() : each.filename().string()))
            left.push_back(&each);
    if (left.empty()) {
        for (const fs::path& each : scenes) left.push_back(&each);
        return {0, fmt::format("no scene fits --scene '{}'; found {}", options.scene, namesOf(left))};
    }
    const auto chosen = [&](const fs::path* scene) {
        return ChosenScene{static_cast<std::size_t>(scene - scenes.data()), {}};
    };
    if (left.size() == 1) return chosen(left.front());
    const auto onlyOne = [&](const auto& fits) -> const fs::path* {
        const auto found = std::find_if(left.begin(), left.end(), fits);
        return found != left.end() && std::none_of(std::next(found), left.end(), fits) ? *found : nullptr;
    };
    const std::string preferred = options.reference.filename().string();
    if (const fs::path* one = onlyOne([&](const fs::path* each) { return each->filename() == preferred; }))
        return chosen(one);
    if (const fs::path* one = onlyOne([&](const fs::path* each) { return each->stem() == submission; }))
        return chosen(one);
    const auto depth = [](const fs::path* each) { return std::distance(each->begin(), each->end()); };
    const auto least = depth(*std::min_element(
        left.begin(), left.end(), [&](const fs::path* a, const fs::path* b) { return depth(a) < depth(b); }));
    if (const fs::path* one = onlyOne([&](const fs::path* each) { return depth(each) == least; }))
        return chosen(one);
    return {0, fmt::format("the folder has {} scenes: {}; expected one, or one named '{}' or '{}.glib'; "
                           "--scene chooses",
                           left.size(), namesOf(left), preferred, submission)};
}

Result<Submissions> findSubmissions(const fs::path& folder, const SubmissionOptions& options) {
    std::error_code failure;
    fs::directory_iterator each(folder, failure);
    if (failure)
        return problem(fmt::format("cannot read the folder of submissions '{}': {}", folder.string(),
                                   failure.message()));
    const auto isOther = [&](const fs::path& path) {
        const auto same = [&](const fs::path& other) {
            std::error_code ignored;
            return !other.empty() && fs::equivalent(path, other, ignored);
        };
        return same(options.reference) || std::any_of(options.others.begin(), options.others.end(), same);
    };
    Submissions found;
    for (; !failure && each != fs::directory_iterator(); each.increment(failure)) {
        const fs::path& path = each->path();
        const std::string name = path.filename().string();
        if (isHidden(path) || isOther(path)) continue;
        if (found.all.size() >= kMostSubmissions)
            return problem(
                fmt::format("'{}' has more than {} submissions", folder.string(), kMostSubmissions));
        switch (typeOf(*each)) {
            case fs::file_type::directory:
                if (name != "shaders" && name != "textures") found.all.push_back(fromFolder(path, options));
                break;
            case fs::file_type::regular:
                if (isScene(path))
                    found.all.push_back({path.stem().string(), folder, path, {}});
                else
                    found.leftOut.push_back(name);
                break;
            case fs::file_type::symlink:
                found.all.push_back({isScene(path) ? path.stem().string() : name,
                                     folder,
                                     {},
                                     "the submission is a link; expected the folder or the file itself"});
                break;
            default:
                found.leftOut.push_back(name);
        }
    }
    if (failure)
        return problem(fmt::format("cannot read all of the folder of submissions '{}': {}", folder.string(),
                                   failure.message()));
    if (found.all.empty())
        return problem(fmt::format("'{}' has no submissions: expected a folder or a .glib file per student",
                                   folder.string()));
    // A folder 'ana' and a file 'ana.glib' are two submissions.
    std::set<std::string> folders;
    for (const Submission& one : found.all)
        if (one.folder != folder) folders.insert(one.name);
    for (Submission& one : found.all)
        if (one.folder == folder && folders.contains(one.name)) one.name += ".glib";
    std::sort(found.all.begin(), found.all.end(),
              [](const Submission& a, const Submission& b) { return a.name < b.name; });
    std::sort(found.leftOut.begin(), found.leftOut.end());
    return found;
}

}  // namespace glibra::classroom
