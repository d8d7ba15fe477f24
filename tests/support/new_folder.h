#pragma once
// A new empty folder among the temporary files, on every system.

#include <filesystem>
#include <stdexcept>
#include <string>

#include "system/file.h"
#include "system/process.h"

namespace glibra::test {

/// `use` becomes a part of its name.
inline std::filesystem::path newFolder(const std::string& use) {
    static int count = 0;
    constexpr int kMost = 10000;
    const std::string name = "glibra-" + use + "-" + std::to_string(system::ownNumber()) + "-";
    while (++count < kMost) {
        const std::filesystem::path path =
            std::filesystem::temp_directory_path() / (name + std::to_string(count));
        if (system::makePrivateFolder(path) == 0) return path;
    }
    throw std::runtime_error("no new folder " + name);
}

}  // namespace glibra::test
