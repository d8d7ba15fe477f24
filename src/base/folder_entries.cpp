#include "base/folder_entries.h"

namespace glibra::base {

namespace fs = std::filesystem;

std::vector<fs::directory_entry> entriesOf(const fs::path& folder, std::error_code& failure) {
    std::vector<fs::directory_entry> entries;
    fs::directory_iterator each(folder, failure);
    for (; !failure && each != fs::directory_iterator(); each.increment(failure)) entries.push_back(*each);
    return entries;
}

std::vector<fs::directory_entry> entriesOf(const fs::path& folder) {
    std::error_code ignored;
    return entriesOf(folder, ignored);
}

}  // namespace glibra::base
