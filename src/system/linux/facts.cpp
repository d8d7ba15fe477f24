#include <link.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <system_error>

#include "system/library.h"
#include "system/places.h"

namespace glibra::system {

namespace fs = std::filesystem;

fs::path programFile() {
    std::error_code failure;
    return fs::read_symlink("/proc/self/exe", failure);
}

std::vector<std::string> ownWords() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::vector<std::string> words;
    for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
    return words;
}

std::string processorFact(std::span<const std::string_view> names) {
    for (const std::string_view name : names) {
        std::ifstream file("/proc/cpuinfo");
        for (std::string line; std::getline(file, line);) {
            const std::size_t colon = line.find(':');
            if (colon == std::string::npos || !line.starts_with(name)) continue;
            if (line.find_first_not_of(" \t", name.size()) != colon) continue;
            const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
            if (begin != std::string::npos) return line.substr(begin);
            break;
        }
    }
    return {};
}

std::uint64_t usableMemory() {
    std::uint64_t bytes = machineMemory();
    for (const char* each : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        std::ifstream file(each);
        std::uint64_t limit = 0;
        if (file >> limit) bytes = std::min(bytes, limit);  // the word "max" is not a number
    }
    return bytes;
}

bool isLibraryLoaded(std::initializer_list<std::string_view> words) {
    const auto isOne = [](dl_phdr_info* library, std::size_t, void* wanted) {
        const std::string_view path = library->dlpi_name;
        const auto& all = *static_cast<std::initializer_list<std::string_view>*>(wanted);
        return std::ranges::any_of(all, [&](std::string_view each) { return path.find(each) != path.npos; })
                   ? 1
                   : 0;
    };
    return dl_iterate_phdr(isOne, &words) != 0;
}

}  // namespace glibra::system
