#pragma once
// Files as wholes: what kind they are, where they come from, and their bytes.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/contained.h"

namespace glibra::base {

// What a file is that stands in the place of a scene, a shader or a model: for messages.

/// "a PNG picture", "a PLY model", "a GLSL shader", "UTF-16 text": with its article, as far as the beginning
/// shows it. Empty for a text that may be anything.
std::string_view fileKind(std::string_view content);

/// "UTF-16 text" or "UTF-32 text"; empty for other files.
std::string_view foreignEncoding(std::string_view content);

/// "is a PNG picture, not a scene", "is UTF-16 text; save it as UTF-8", "is a binary file, not a scene";
/// empty for a text that may be what is wanted.
std::string notThe(std::string_view wanted, std::string_view content);

/// True for a file that is no text of UTF-8 or of one byte for each character.
bool isNoText(std::string_view content);

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

/// Writes out what standard output still buffers. Returns why not all that was ever written to it has arrived
/// (a full disk, a closed descriptor), or an empty text. Call it last in main: only then is it known whether
/// the output is whole.
std::string endStandardOutput();

// The content of folders that other programs may change, remove or forbid meanwhile.

/// Returns the entries of a folder, in no order. If the folder cannot be read to its end, returns those that
/// were found, and `failure` says why. A plain loop over a directory_iterator throws then.
std::vector<std::filesystem::directory_entry> entriesOf(const std::filesystem::path& folder,
                                                        std::error_code& failure);
/// The same, without the reason of a failure.
std::vector<std::filesystem::directory_entry> entriesOf(const std::filesystem::path& folder);

// The whole content of files that were opened by the functions of contained.h.

/// The content of an open file of at most `largest` bytes. Nothing if it is not open or cannot be read.
std::optional<std::vector<std::byte>> bytesIn(const system::File& file, std::uint64_t largest);
/// The same as text, which may have any bytes.
std::optional<std::string> textIn(const system::File& file, std::uint64_t largest);

/// The bytes as text.
inline std::string_view asText(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace glibra::base
