#pragma once
// Whole files: read and written, and the limits and messages of what is read.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/files.h"
#include "system/file.h"

namespace glibra::image {

// Sizes beyond which nothing is read (language, 11). Every product is computed with 64 bits and checked
// before memory is reserved.

inline constexpr std::uint64_t kGiB = std::uint64_t{1} << 30;

/// What the pictures, raw textures and noise textures of a scene may have together.
inline constexpr std::uint64_t kSceneTexelBytes = 2 * kGiB;

/// The largest picture that a caller accepts. The defaults are the limits for textures of a scene.
struct Limits {
    std::uint64_t fileBytes = 2 * kGiB;
    std::uint64_t texelBytes = kGiB;
    int side = 16384;
    int side3D = 2048;  ///< of a 3D texture
    /// What the textures of a scene may still have together.
    std::uint64_t sceneBytesLeft = kSceneTexelBytes;
};

/// For pictures that may be drawn by glibra: the sides that --size takes.
inline constexpr Limits kDrawnLimits{.texelBytes = 4 * kGiB, .side = 65'536, .sceneBytesLeft = 4 * kGiB};

/// The name of a file in messages, and the place in the scene that refers to it.
struct FileLabel {
    std::string name;
    Place place;
};

/// file-E09 if width x height pixels of `bytesPerPixel` exceed the limits; draw-E08 if they exceed what is
/// left for the scene.
std::optional<Diagnostic> checkSize(std::uint64_t width, std::uint64_t height, std::uint64_t bytesPerPixel,
                                    const Limits& limits, const FileLabel& label);

/// draw-E08 if `bytes` are more than is left for the scene. `what` names the texture, as "'a.png'".
std::optional<Diagnostic> checkSceneBytes(std::uint64_t bytes, const Limits& limits, const std::string& what,
                                          const Place& place);

/// file-E04 if a file is so short that it cannot hold the pixels that it announces. No format packs them
/// without bound, but some readers make a picture of what a damaged file lacks.
std::optional<Diagnostic> checkInflation(std::uint64_t width, std::uint64_t height, std::uint64_t fileBytes,
                                         const FileLabel& label);

/// checkSize, then checkInflation.
std::optional<Diagnostic> checkPacked(std::uint64_t width, std::uint64_t height, std::uint64_t bytesPerPixel,
                                      std::uint64_t fileBytes, const Limits& limits, const FileLabel& label);

/// The messages of language, 8.2 that several readers report. `damaged` is file-E04: "'name': what".
Diagnostic damaged(const FileLabel& label, const std::string& what);

/// file-E04 for pixels that end too early: the file has only `rows` of `height` rows.
Diagnostic endsEarly(const FileLabel& label, std::uint64_t rows, std::uint64_t height);

// Reads and writes whole files. Reading never blocks and never exceeds the given size. A written file appears
// under its name only when it is complete.

/// The content of a file. Errors: file-E01 missing; file-E02 empty; file-E14 unreadable, a folder or another
/// special file (pipes and devices would block); file-E09 longer than `largest` bytes.
Result<std::vector<std::byte>> readFile(const base::FileSource& file, const FileLabel& label,
                                        std::uint64_t largest = 2 * kGiB);

/// file-E10 for the file at `path`.
Diagnostic cannotWrite(const std::filesystem::path& path, const std::string& why);

/// Who chose the name of a file that is written.
enum class NamedBy {
    user,    ///< a link there keeps its target, and a device or pipe (/dev/stdout) is written directly
    program  ///< whatever has that name, and is no folder, is replaced; the target of a link stays as it is
};

/// The file appears under its name when it is complete, so that nobody sees an incomplete file and an
/// existing file survives a failure. It has the permissions and the group of the file that it replaces. Empty
/// on success; otherwise one file-E10, and no temporary file remains.
///
/// If the user named the file, it keeps its owner, too. A file that another one cannot stand for is written
/// over instead: one with several names (hard links), with an access list, or of another owner.
Diagnostics writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes,
                                NamedBy named = NamedBy::user);

/// Moves a complete file to `target` in the same file system, as writeFileAtomically would write it there. A
/// link is replaced. Empty on success; otherwise one file-E10.
Diagnostics moveIntoPlace(const std::filesystem::path& from, const std::filesystem::path& target,
                          NamedBy named);

/// Removes the temporary files of a process that ended while it was writing into a folder.
void removeTemporaryFiles(const std::filesystem::path& folder, int process);

/// What follows the number of the process in the name of a folder for files that are not complete.
inline constexpr std::string_view kStaging = "-untrusted";

/// Removes temporary files from a folder whose processes were killed before they could do it: those of this
/// user that nobody has written to for a minute, since another machine may write into the folder, too, and
/// its folders for files that are not complete (kStaging) after a day.
void removeAbandonedFiles(const std::filesystem::path& folder);

/// A temporary file beside `target`, for code that writes the file itself. The file is removed unless
/// `commit` succeeds.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::filesystem::path& target, NamedBy named = NamedBy::user);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile();

    /// Keeps the suffix of the target. The file exists and is empty; if it could not be created, the path is
    /// empty.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Open for writing; empty if it could not be created.
    [[nodiscard]] const system::File& file() const { return file_; }
    /// Moves the file into place. Empty on success, otherwise one file-E10.
    Diagnostics commit();
    /// The file-E10 for the last step that failed.
    [[nodiscard]] Diagnostic failure() const;

  private:
    std::filesystem::path target_, path_;
    NamedBy named_;
    system::File file_;
    int lastError_ = 0;
};

}  // namespace glibra::image
