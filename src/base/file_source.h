#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace glibra::base {

/// A file to read: one of the disk, or one whose content the calling program gave.
struct FileSource {
    std::filesystem::path path{};                  ///< also gives its name and its suffix
    std::shared_ptr<const std::string> content{};  ///< null: what the disk has

    FileSource() = default;
    FileSource(std::filesystem::path onDisk) : path(std::move(onDisk)) {}
    FileSource(const std::string& onDisk) : path(onDisk) {}
    FileSource(const char* onDisk) : path(onDisk) {}
    FileSource(std::filesystem::path name, std::shared_ptr<const std::string> bytes)
        : path(std::move(name)), content(std::move(bytes)) {}
};

}  // namespace glibra::base
