#pragma once
// Whole files, in and out. Reading never blocks and never reads more than was allowed; what is written
// appears under its name only when it is whole.

#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "image/limits.h"

namespace glibra::image {

/// The content of a file. Errors: file-E01 no such file; file-E02 empty, unreadable, a folder or no ordinary
/// file (pipes and devices are not waited for); file-E09 longer than `largest` bytes.
Result<std::vector<std::byte>> readFile(const std::filesystem::path& path, const FileLabel& label,
                                        std::uint64_t largest = 2 * kGiB);

/// Writes a file under a temporary name in its own folder and renames it when it is whole, so that nobody
/// ever sees half of it and an existing file survives a failure. A link keeps pointing where it points; a
/// device or pipe (/dev/stdout) is written to directly. Empty if that worked, else one file-E10 and nothing
/// is left behind.
Diagnostics writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes the temporary files that a process left in a folder when it was ended in the middle of writing.
void removeTemporaryFiles(const std::filesystem::path& folder, int process);

/// A temporary name beside `target`, for what writes its file itself. The file is removed unless `commit`
/// succeeds.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::filesystem::path& target);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile();

    /// Keeps the target's suffix. The file exists and is empty; if it could not be made, the path is empty.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Open for writing, or -1.
    [[nodiscard]] int descriptor() const { return descriptor_; }
    /// Gives the file its final name. Empty if that worked, else one file-E10.
    Diagnostics commit();
    /// The file-E10 of the step that failed last.
    [[nodiscard]] Diagnostic failure() const;

  private:
    void closeDescriptor();

    std::filesystem::path target_, path_;
    int descriptor_ = -1;
    int lastError_ = 0;
};

}  // namespace glibra::image
