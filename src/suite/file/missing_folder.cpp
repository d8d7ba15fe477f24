#include "suite/file/missing_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/suggest.h"
#include "glib/text.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostEntries = 10'000;

std::vector<std::string> foldersIn(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code failure;
    fs::directory_iterator each(folder, failure);
    for (; !failure && each != fs::directory_iterator() && names.size() < kMostEntries;
         each.increment(failure)) {
        std::error_code ignored;
        if (each->is_directory(ignored)) names.push_back(each->path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

}  // namespace

std::string whyNoFolder(const fs::path& folder) {
    fs::path known;
    for (const fs::path& part : folder) {
        std::error_code failure;
        const fs::path next = known / part;
        if (part.empty() || fs::is_directory(next, failure)) {
            known = next;
            continue;
        }
        const std::vector<std::string> beside = foldersIn(known.empty() ? "." : known);
        const std::vector<std::string_view> names(beside.begin(), beside.end());
        return fmt::format("there is no folder {}{}", glib::inQuotes(next.string()),
                           base::suggestion(part.string(), names));
    }
    return {};
}

}  // namespace glibra::suite
