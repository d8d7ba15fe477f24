#include "system/posix/extras.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <system_error>

#include "system/library.h"
#include "system/places.h"

namespace glibra::system {
namespace {

/// Between the making of a descriptor and this call another thread may start a program, which inherits it.
void closeInPrograms(const int (&ends)[2]) {
    for (const int each : ends) ::fcntl(each, F_SETFD, FD_CLOEXEC);
}

}  // namespace

bool openPipe(int (&ends)[2]) {
    if (::pipe(ends) != 0) return false;
    closeInPrograms(ends);
    return true;
}

bool openSockets(int (&ends)[2]) {
    if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) return false;
    closeInPrograms(ends);
    return true;
}

bool openWaker(int& reading, int& writing) {
    int ends[2];
    if (!openPipe(ends)) return false;
    reading = ends[0];
    writing = ends[1];
    return true;
}

int passingMode() {
    return O_RDONLY;
}

bool hasAccessList(int) {
    return false;
}

int openUnnamed(int, const char*, int, mode_t) {
    return -1;
}

int nameFile(int, int, const std::filesystem::path&) {
    return ENOTSUP;
}

int openMemoryFile(const char*) {
    std::error_code failure;
    std::string name = (std::filesystem::temp_directory_path(failure) / "glibra-XXXXXX").string();
    if (failure) return -1;
    const int file = ::mkstemp(name.data());
    if (file < 0) return -1;
    ::unlink(name.c_str());
    ::fcntl(file, F_SETFD, FD_CLOEXEC);
    return file;
}

std::string pathOf(int file) {
    return "/dev/fd/" + std::to_string(file);
}

std::string pathOfThisProgram() {
    return programFile().string();
}

bool hasOneThread() {
    return false;
}

void endWithParent() {}

void beFirstToEnd() {}

int descriptorOf(pid_t) {
    return -1;
}

double processorSecondsOf(pid_t) {
    return 0;
}

std::uint64_t dataBytes() {
    constexpr std::uint64_t kUnit = 1024;  // of ru_maxrss on Linux
    rusage usage{};  // resident memory, also of libraries: more than what can be written
    return ::getrusage(RUSAGE_SELF, &usage) == 0 ? static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit : 0;
}

// What POSIX does not tell.

namespace fs = std::filesystem;

namespace {

struct Start {
    std::vector<std::string> words;
    fs::path folder;  ///< the current one
};

Start& startOfProgram() {
    static Start start;
    return start;
}

/// The loaders of the GNU C library and of macOS call it before main, with the arguments of main.
[[gnu::constructor]] void note(int count, char** words) {
    Start& start = startOfProgram();
    start.words.assign(words, words + count);
    std::error_code failure;
    start.folder = fs::current_path(failure);
}

}  // namespace

fs::path programFile() {
    const auto& [words, folder] = startOfProgram();
    if (words.empty()) return {};
    const fs::path name = words.front();
    const fs::path file = name.has_parent_path() ? folder / name : findInPath(name.string());
    std::error_code failure;
    const fs::path whole = fs::canonical(file, failure);
    return failure ? fs::path() : whole;
}

std::vector<std::string> ownWords() {
    return startOfProgram().words;
}

std::string processorFact(std::span<const std::string_view>) {
    return {};
}

std::uint64_t usableMemory() {
    return machineMemory();
}

bool isLibraryLoaded(std::initializer_list<std::string_view>) {
    return true;  // as if: who asks does without what it has to be unloaded for
}

}  // namespace glibra::system
