#pragma once
// Open files, what a path or an open file is, and the bytes of a transfer. Error numbers are those of
// <cerrno>, which std::generic_category() puts into words; 0 is success. A function that gives a File says by
// errno why it gives none. No function here blocks for a pipe or a device that nobody writes to, but for
// openToOverwrite.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

namespace glibra::system {

/// What the system knows an open file, pipe or folder by. Only the implementations look into it.
using Handle = std::intptr_t;
inline constexpr Handle kNoHandle = -1;

/// An open file, pipe or folder, which closes itself. No program that this one starts inherits it.
class File {
  public:
    File() = default;
    explicit File(Handle handle) : handle_(handle) {}
    File(File&& other) noexcept : handle_(other.handle_) { other.handle_ = kNoHandle; }
    File& operator=(File&& other) noexcept;
    ~File();  ///< leaves errno as it is
    [[nodiscard]] Handle handle() const { return handle_; }
    explicit operator bool() const { return handle_ != kNoHandle; }
    /// Closes it before its time. Returns the error number of a write that only closing reports.
    int close();

  private:
    Handle handle_ = kNoHandle;
};

enum class FileKind { missing, regular, folder, link, other };

/// What the system knows of a file.
struct FileFacts {
    FileKind kind = FileKind::missing;
    std::uint64_t size = 0;   ///< bytes
    std::uint64_t names = 0;  ///< hard links
    bool isOwn = false;       ///< it belongs to the user of this process
    std::uint64_t device = 0, number = 0;
    std::int64_t seconds = 0, nanoseconds = 0;  ///< of the last change of its content, since 1970
};

enum class Links { followed, notFollowed };

/// Returns 0, or an error number (ENOENT, ELOOP, EACCES, ...) with a kind of `missing`.
int factsOf(const std::filesystem::path& path, Links links, FileFacts& facts);
int factsOf(const File& file, FileFacts& facts);
/// The kind alone.
FileKind kindOf(const std::filesystem::path& path, Links links);

/// Device, number, size and time of a file: another file, or another content, has others. Zeros: there is
/// none.
using FileIdentity = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, std::int64_t, std::int64_t>;
FileIdentity identityOf(const std::filesystem::path& path);

File openToRead(const std::filesystem::path& path, Links links);
/// For devices and pipes that the user named. Waits for somebody who reads from a pipe.
File openToOverwrite(const std::filesystem::path& path);
/// Every write goes to the end of the file, also when other processes write to it. Links are not followed.
File openToAppend(const std::filesystem::path& path);
/// Makes a file that did not exist, with the permissions that are usual for the user. EEXIST: it exists.
File makeNewFile(const std::filesystem::path& path);
/// Makes a folder for this user alone. Returns 0 or an error number; EEXIST for anything of that name.
int makePrivateFolder(const std::filesystem::path& path);

/// Writes all bytes. Returns 0 or an error number.
int writeAll(const File& file, std::span<const std::byte> bytes);
inline int writeAll(const File& file, std::string_view text) {
    return writeAll(file, std::as_bytes(std::span(text)));
}
/// Appends in one piece. Returns 0, or the error number; the file is then as before.
int appendWhole(const File& file, std::string_view text);
/// Fills `bytes`, or as much of them as the file has; `count` says how much. Returns 0 or an error number.
int readFull(const File& file, std::span<std::byte> bytes, std::size_t& count);
/// Fills `bytes` from a pipe. False if it ends before, or cannot be read.
bool receiveAll(const File& pipe, std::span<std::byte> bytes);

/// Writes to the disk what the system holds of a file. File systems without that cannot lose it either.
int sync(const File& file);
/// The same for the content alone, without times.
void syncContent(const File& file);

/// A new pipe. Returns 0 or an error number.
int makePipe(File& reading, File& writing);

// Places of files in memory.

/// Requests memory of `size` bytes without touching it, in large pages if the system has them: page faults of
/// small pages took half of the reading time of a large file. std::bad_alloc as reserve().
void reserveLarge(std::vector<std::byte>& bytes, std::size_t size);

// Locks, which the system gives back when the process ends, however it does.

/// A lock that this process has. A process that was forked meanwhile does not release it.
class Lock {
  public:
    enum class Try {
        taken,
        held,    ///< another process has it
        none,    ///< the file system has no locks
        missing  ///< there is no such file or folder, or it cannot be made
    };
    enum class Wait { no, yes };

    Lock() = default;
    Lock(Lock&&) noexcept = default;
    Lock& operator=(Lock&&) noexcept = default;
    ~Lock() { release(); }

    /// Locks the folder itself, so that no lock file is left in it.
    Try takeFolder(const std::filesystem::path& folder, Wait wait);
    /// Makes a new file for this user alone, and locks it. `held` also if somebody has removed it meanwhile.
    Try takeNewFile(const std::filesystem::path& file);
    [[nodiscard]] bool isTaken() const { return isTaken_; }
    void release();

  private:
    File file_;
    int owner_ = 0;
    bool isTaken_ = false;
};
/// True if another Lock has the file, mostly that of another process. A file that nobody has locked is
/// removed, before anybody can lock it.
bool removeUnlessLocked(const std::filesystem::path& file);

}  // namespace glibra::system
