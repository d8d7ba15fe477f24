#include "suite/golden/orphans.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "image/convert.h"
#include "image/read.h"
#include "suite/file/suite_file.h"
#include "suite/golden/golden_store.h"
#include "suite/golden/hash.h"
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

/// The shots that are compared with a golden of their own.
std::set<std::string> shotNames(const Suite& suite) {
    std::set<std::string> names;
    for (const Shot& each : suite.shots)
        if (hasOwnGolden(each)) names.insert(each.name);
    return names;
}

/// Reads the other suites in the folder of the suite's file, which may have their goldens in the same folder.
/// Returns false if one of the TOML files there cannot be read as a suite, so that its goldens are unknown.
bool suitesBeside(const Suite& suite, std::vector<Suite>& beside) {
    std::error_code failure;
    if (!fs::is_regular_file(suite.file, failure)) return true;
    bool allRead = true;
    for (const fs::directory_entry& each :
         base::entriesOf(suite.file.has_parent_path() ? suite.file.parent_path() : ".")) {
        const fs::path& file = each.path();
        if (file.extension() != ".toml" || !each.is_regular_file(failure) ||
            fs::equivalent(file, suite.file, failure))
            continue;
        Result<Suite> read = readSuite(file);
        allRead = allRead && read;
        if (read) beside.push_back(std::move(*read));
    }
    return allRead;
}

}  // namespace

std::vector<fs::path> orphanGoldens(const Suite& suite, const fs::path& folder,
                                    std::span<const Suite> others) {
    const fs::path root = goldenFolder(suite, folder);
    const std::set<std::string> shots = shotNames(suite);
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
    if (found.empty()) return {};
    std::vector<Suite> beside;
    if (folder.empty() && !suitesBeside(suite, beside)) hasOthers = true;
    for (const std::span<const Suite> some : {others, std::span<const Suite>(beside)})
        for (const Suite& other : some) {
            const fs::path otherRoot = goldenFolder(other, folder);
            const std::set<std::string> names = shotNames(other);
            std::erase_if(found, [&](const auto& each) {
                return belongsTo(names, fs::weakly_canonical(each.first, failure)
                                            .lexically_relative(fs::weakly_canonical(otherRoot, failure))
                                            .replace_extension()
                                            .generic_string());
            });
        }
    if (hasOthers) {
        const Result<HashList> list = HashList::read(root / (suite.name + ".hashes"));
        const std::set<std::string> known = list ? list->shots() : std::set<std::string>();
        std::erase_if(found, [&](const auto& each) { return !belongsTo(known, each.second); });
    }
    std::vector<fs::path> orphans;
    for (auto& [file, name] : found) orphans.push_back(std::move(file));
    std::ranges::sort(orphans);
    return orphans;
}

fs::path Orphans::find(const image::Image& picture) const {
    if (isEmpty()) return {};
    // A golden that was read has an alpha, which a rendering need not have.
    const auto keyOf = [](const image::Image& each) {
        return toText(hashOf(image::withComponents(each, 4)));
    };
    std::call_once(isRead_, [&] {
        for (const fs::path& file : files_)
            if (const Result<image::Image> golden = image::readImage(file))
                ofPixels_.emplace(keyOf(*golden), file);
    });
    const auto found = ofPixels_.find(keyOf(picture));
    return found == ofPixels_.end() ? fs::path() : found->second;
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
