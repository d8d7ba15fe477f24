#include "classroom/file_names.h"

#include <fmt/format.h>

#include <cstddef>
#include <set>
#include <string_view>

#include "base/text.h"
#include "base/utf8.h"
#include "suite/file/shot_name.h"

namespace glibra::classroom {
namespace {

/// True for the names of devices, which Windows gives no file, whatever follows a point.
bool isOfWindows(std::string_view name) {
    std::string word(name.substr(0, name.find('.')));
    while (word.ends_with(' ')) word.pop_back();
    for (const char* each : {"con", "prn", "aux", "nul", "conin$", "conout$"})
        if (base::sameWord(word, each)) return true;
    return word.size() == 4 && word[3] >= '0' && word[3] <= '9' &&
           (base::sameWord(word.substr(0, 3), "com") || base::sameWord(word.substr(0, 3), "lpt"));
}

std::string allowed(std::string_view name) {
    constexpr std::size_t kMostBytes = 200;
    std::string made;
    while (!name.empty()) {
        const base::Character next = base::firstCharacter(name);
        if (made.size() + next.bytes > kMostBytes) break;
        const bool isBad = !next.valid || next.code < ' ' || next.code == 0x7F ||
                           (next.code < 0x80 &&
                            std::string_view("/\\:*?\"<>|").find(name.front()) != std::string_view::npos);
        made += isBad ? "_" : name.substr(0, next.bytes);
        name.remove_prefix(next.bytes);
    }
    while (made.ends_with('.') || made.ends_with(' ')) made.pop_back();  // Windows drops them
    return made;
}

}  // namespace

std::vector<std::string> fileNames(std::vector<std::string> names) {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::string name = allowed(names[i]);
        if (name.empty() || name.front() == '.' || isOfWindows(name) ||
            taken.contains(suite::nameOnAnyDisk(name)))
            name = fmt::format("{:04} {}", i + 1, name);
        while (!taken.insert(suite::nameOnAnyDisk(name)).second) name += '_';
        names[i] = std::move(name);
    }
    return names;
}

}  // namespace glibra::classroom
