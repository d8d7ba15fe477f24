#include "suite/golden/orphans.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <system_error>

#include "suite/golden/hash_list.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

bool isPicture(const fs::path& file) {
    return file.extension() == ".png" || file.extension() == ".exr";
}

/// The name of the shot of a golden "NAME.png" or "NAME.VARIANT.png" among `shots`, or empty.
bool belongsTo(const std::set<std::string>& shots, const std::string& stem) {
    if (shots.contains(stem)) return true;
    const std::size_t dot = stem.rfind('.');
    return dot != std::string::npos && shots.contains(stem.substr(0, dot));
}

}  // namespace

std::vector<fs::path> orphanGoldens(const Suite& suite, const fs::path& folder) {
    const fs::path root = folder.empty() ? suite.goldens : folder / suite.name;
    std::set<std::string> shots;
    for (const Shot& each : suite.shots) shots.insert(each.name);
    std::vector<std::pair<fs::path, std::string>> found;  // with the name that a shot would have
    bool hasOthers = false;
    std::error_code failure;
    for (fs::recursive_directory_iterator each(root, failure), end; !failure && each != end;
         each.increment(failure)) {
        const fs::path& file = each->path();
        if (file.filename().string().starts_with('.') || each->is_symlink(failure) ||
            !each->is_regular_file(failure))
            continue;
        if (file.extension() == ".hashes") {
            if (file.stem() != suite.name) return {};
        } else if (!isPicture(file)) {
            hasOthers = hasOthers || (file.extension() != ".md" && file.extension() != ".txt");
        } else {
            const std::string name = file.lexically_relative(root).replace_extension().generic_string();
            if (!belongsTo(shots, name)) found.emplace_back(file, name);
        }
    }
    if (hasOthers) {
        const Result<HashList> list = HashList::read(root / (suite.name + ".hashes"));
        const std::set<std::string> known = list ? list->shots() : std::set<std::string>();
        std::erase_if(found, [&](const auto& each) { return !belongsTo(known, each.second); });
    }
    std::vector<fs::path> orphans;
    for (auto& [file, name] : found) orphans.push_back(std::move(file));
    std::sort(orphans.begin(), orphans.end());
    return orphans;
}

Diagnostics removeOrphans(const std::vector<fs::path>& orphans) {
    Diagnostics problems;
    for (const fs::path& each : orphans) {
        std::error_code failure;
        if (!fs::remove(each, failure) || failure) {
            problems.push_back(diagnose(
                "file-E10", fmt::format("cannot remove '{}': {}", each.string(), failure.message())));
            continue;
        }
        // Fails for a folder that is not empty, and so never removes the golden folder of a suite with
        // goldens.
        for (fs::path folder = each.parent_path();
             !folder.empty() && fs::remove(folder, failure) && !failure;)
            folder = folder.parent_path();
    }
    return problems;
}

}  // namespace glibra::suite
