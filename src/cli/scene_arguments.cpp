#include "cli/scene_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/text.h"
#include "glib/limits.h"
#include "glib/text.h"
#include "scene/file_lookup.h"
#include "suite/file/selection.h"
#include "suite/options/option_words.h"
#include "system/terminal.h"

namespace glibra::cli {
namespace {

Diagnostics readStandardInput(std::string& to) {
    const Place place{kStandardInput, 1, 1};
    std::array<char, 65536> block;
    for (;;) {
        std::size_t count = 0;
        if (const int problem = system::readInput(block, count); problem != 0)
            return {diagnose("glib-E14", fmt::format("cannot read the scene: {}", std::strerror(problem)),
                             place)};
        if (count == 0) return {};
        to.append(block.data(), count);
        if (to.size() > glib::kLargestFile)
            return {diagnose("glib-E15",
                             fmt::format("the scene has more than {} bytes",
                                         base::groupedText(static_cast<long long>(glib::kLargestFile))),
                             place)};
    }
}

}  // namespace

Diagnostics resolveScenes(const std::vector<std::string>& words, SceneArguments& to) {
    namespace fs = std::filesystem;
    Diagnostics problems;
    for (const std::string& each : words) {
        std::error_code failure;
        if (each == "-") {
            if (to.standardInput) {
                problems.push_back(diagnose("glib-E14",
                                            "- stands for standard input, which has one scene only",
                                            {kStandardInput, 1, 1}));
                continue;
            }
            append(problems, readStandardInput(to.standardInput.emplace()));
            to.scenes.emplace_back(kStandardInput);
        } else if (fs::is_directory(each, failure)) {
            to.hasFolder = true;
            const Result<std::vector<fs::path>> found = suite::scenesBelow(each);
            if (!found.diagnostics.empty())
                append(problems, found.diagnostics);
            else if (!found || found->empty())
                problems.push_back(diagnose("glib-E14",
                                            found ? "there is no scene (.glib) in this folder"
                                                  : "the folder has too many files to search for scenes",
                                            {each, 1, 1}));
            else
                for (const fs::path& scene : *found) to.scenes.push_back(scene.generic_string());
        } else {
            to.scenes.push_back(each);
        }
    }
    return problems;
}

RenderOptions optionsFor(const std::string& scene, const std::optional<std::string>& standardInput,
                         const RenderOptions& options) {
    RenderOptions own = options;
    if (standardInput && scene == kStandardInput) own.sceneText = *standardInput;
    return own;
}

namespace fs = std::filesystem;

Diagnostics libraryHint(const fs::path& scene, const Diagnostics& diagnostics, const fs::path& library) {
    // glsl-E01 has a subject only if a file is not found by #include.
    const auto isMissing = [](const Diagnostic& each) {
        return each.id == "file-E01" || (each.id == "glsl-E01" && !each.subject.empty());
    };
    if (library.empty() || std::none_of(diagnostics.begin(), diagnostics.end(), isMissing)) return {};
    scene::FolderListings listings;
    const scene::SearchFolders folders = scene::searchFolders(scene, {.libraryRoots = {library}});
    for (const Diagnostic& each : diagnostics) {
        const std::string& name = each.subject;
        // The library of the scene has a file of that name in another folder, which the message says.
        if (!isMissing(each) || name.empty() || !each.suggestion.empty()) continue;
        const scene::FileReference found = scene::findFile(name, {}, folders, listings);
        // "../secret.frag" and "/proc/version" are found, but not in the library.
        const fs::path written(name);
        if (written.is_absolute() || std::find(written.begin(), written.end(), "..") != written.end())
            continue;
        std::string other;
        for (const Diagnostic& remark : found.remarks) other = remark.suggestion;
        if (found.path.empty() && other.empty()) continue;
        const std::string as = found.path.empty() ? fmt::format(" as '{}'", other) : "";
        const char* const finds = as.empty() ? "finds it" : "finds it by that name";
        return {
            withoutId(Severity::note, fmt::format("the library of glibra has '{}'{}; --library {} {}", name,
                                                  as, suite::shellWord(library.generic_string()), finds))};
    }
    return {};
}

}  // namespace glibra::cli
