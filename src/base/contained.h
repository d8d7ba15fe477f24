#pragma once
// Files below folders that somebody chose. A results file, a suite or a scene may have been written by
// somebody else and name any file of this machine. What such a file names is shown, copied, written or
// removed only through these functions. They return 0 or an error number, and never block.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "system/file.h"

namespace glibra::base {

/// Opens an ordinary file below `root` for reading. `path` is relative to `root` and leads downwards: it has
/// no "..". None of its parts may be a link; `root` itself may be one. Without a value errno says why: EINVAL
/// for a path that does not lead downwards, ELOOP for a link, ENOTSUP for a folder, a pipe or a device.
system::File openBeneath(const std::filesystem::path& root, const std::filesystem::path& path);

/// Reads an open file from its beginning. EFBIG: it is longer than `largest` bytes.
int readAll(const system::File& file, std::uint64_t largest, std::vector<std::byte>& bytes);

/// Writes a file below `root` and makes its folders, also `root`. The file appears under its name when it is
/// whole and on the disk, so that a loss of power leaves the old file or the new one, and keeps the access of
/// the old one (system::keepAccess). A link of that name is replaced, and its target stays as it is.
int writeBeneath(const std::filesystem::path& root, const std::filesystem::path& path,
                 std::span<const std::byte> bytes);

/// Makes `root` and the folders of `path` below it, and removes a link, a pipe or a device that has its name,
/// so that code which knows only paths can write there.
int prepareBeneath(const std::filesystem::path& root, const std::filesystem::path& path);

/// Makes `root` and the folders of `path` below it, if they do not exist. ELOOP: one of them, below `root`,
/// is a link.
int makeFoldersBeneath(const std::filesystem::path& root, const std::filesystem::path& path);

/// Removes a file below `root`; a link is removed, not its target.
int removeBeneath(const std::filesystem::path& root, const std::filesystem::path& path);

/// The folders whose files may be shown: to a reader of a report, of a message, of a translated shader.
class Roots {
  public:
    /// A folder that does not exist is ignored. It may be reached through links, so it must be one that the
    /// user named.
    void add(const std::filesystem::path& folder);
    /// The same for a folder whose name somebody else chose: it is ignored unless it lies below `root` after
    /// all links are resolved.
    void addBelow(const std::filesystem::path& root, const std::filesystem::path& folder);

    /// True if the file lies below a root after all links are resolved, and nothing between them is hidden,
    /// as .git and .ssh are.
    [[nodiscard]] bool contains(const std::filesystem::path& file) const;
    /// Opens a file that lies below a root without following any link (openBeneath). EACCES: it is not
    /// below any root, or it is hidden.
    [[nodiscard]] system::File open(const std::filesystem::path& file) const;

  private:
    std::vector<std::filesystem::path> folders_;  ///< as they were named, absolute, and with links resolved
};

}  // namespace glibra::base
