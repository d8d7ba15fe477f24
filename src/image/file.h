#pragma once
// Reads and writes whole files. Reading never blocks and never exceeds the given size. A written file appears
// under its name only when it is complete.

#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/files.h"
#include "image/limits.h"
#include "system/file.h"

namespace glibra::image {

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

/// Removes temporary files from a folder whose processes were killed before they could do it: those of this
/// user that nobody has written to for a minute, since another machine may write into the folder, too.
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
