#include "cli/library_hint.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "scene/file_lookup.h"
#include "suite/options/option_words.h"

namespace glibra::cli {

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
