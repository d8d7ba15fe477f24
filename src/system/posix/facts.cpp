// What POSIX does not tell: src/system/linux/facts.cpp replaces this file.

#include <cstdint>
#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

#include "system/library.h"
#include "system/places.h"
#include "system/process.h"

namespace glibra::system {

namespace fs = std::filesystem;

namespace {

struct Start {
    std::vector<std::string> words;
    fs::path folder;  ///< the current one
};

Start& startOfProgram() {
    static Start start;
    return start;
}

/// The loaders of the GNU C library and of macOS call it before main, with the arguments of main.
[[gnu::constructor]] void note(int count, char** words) {
    Start& start = startOfProgram();
    start.words.assign(words, words + count);
    std::error_code failure;
    start.folder = fs::current_path(failure);
}

}  // namespace

fs::path programFile() {
    const auto& [words, folder] = startOfProgram();
    if (words.empty()) return {};
    const fs::path name = words.front();
    const fs::path file = name.has_parent_path() ? folder / name : findInPath(name.string());
    std::error_code failure;
    const fs::path whole = fs::canonical(file, failure);
    return failure ? fs::path() : whole;
}

std::vector<std::string> ownWords() {
    return startOfProgram().words;
}

std::string processorFact(std::span<const std::string_view>) {
    return {};
}

std::uint64_t usableMemory() {
    return machineMemory();
}

bool isLibraryLoaded(std::initializer_list<std::string_view>) {
    return true;  // as if: who asks does without what it has to be unloaded for
}

}  // namespace glibra::system
