#pragma once
// Unpacks the zip files of strangers, with minizip. It runs in worker processes.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace glibra::classroom {

/// What one submission may unpack. A zip file may promise, and hold, terabytes.
struct UnpackLimits {
    std::uint64_t bytes = std::uint64_t{256} << 20U;
    std::size_t entries = 20'000;  ///< files, and folders that are made for them
};

/// True for a file name that ends with ".zip".
bool isArchive(const std::filesystem::path& file);

/// Unpacks a zip file into a folder, which must exist, and takes what it uses from `limits`. Only ordinary
/// files are made, with names that lead downwards; links, hidden files and what macOS adds ("__MACOSX") are
/// left out. Returns an empty text, or why the file cannot be unpacked: it is no zip file, is encrypted,
/// ends too early, or reaches a limit; then the folder may have a part of it.
std::string unpackArchive(const std::filesystem::path& archive, const std::filesystem::path& into,
                          UnpackLimits& limits);

}  // namespace glibra::classroom
