#pragma once
// What systems have beyond POSIX, for the files of this folder. src/system/posix/extras.cpp does without it;
// src/system/linux/extras.cpp replaces it. Error numbers are in errno.

#include <sys/types.h>

#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "system/process.h"

namespace glibra::system {

inline int numberOf(const File& file) {
    return static_cast<int>(file.handle());
}

/// Both ends, which no other program inherits. False: errno.
bool openPipe(int (&ends)[2]);
/// Two connected sockets, which are closed in programs that this one starts, too.
bool openSockets(int (&ends)[2]);

/// How a folder is opened that is only gone through.
int passingMode();
/// True if a file has an access list (ACL): its mode does not say who may read it.
bool hasAccessList(int file);
/// A file without a name, in a folder that is named by its path from an open one; -1: the system or a sandbox
/// has none.
int openUnnamed(int folder, const char* path, int access, mode_t mode);
/// Puts such a file in the place of a name. Returns 0, or an error number; ENOTSUP: it cannot be done.
int nameFile(int folder, int file, const std::filesystem::path& name);
/// A file in memory, for `what`; -1: none.
int openMemoryFile(const char* what);
/// A path by which this process can open an open file; empty: there is none.
std::string pathOf(int file);

/// When memory runs out, the system ends this process before others.
void beFirstToEnd();
/// A descriptor that can be polled for the end of a process; -1: none.
int descriptorOf(pid_t process);
/// Seconds of processor time that a child has used; 0 if the system does not tell.
double processorSecondsOf(pid_t process);
/// The private writable memory of this process; 0 if the system does not tell.
std::uint64_t dataBytes();

/// What a Waker is made of: one descriptor for both ends, or a pipe. It takes 8 bytes.
bool openWaker(int& reading, int& writing);

// How the files of this folder start programs (process.cpp).

/// As exec takes them, while `words` lives.
std::vector<char*> pointersTo(const std::vector<std::string>& words);

/// Null as `program`: the first word is searched in PATH. Each pair of descriptors is one of this process and
/// the number that it has in the program.
Process spawn(const char* program, const std::vector<std::string>& words, const Streams& streams,
              std::initializer_list<std::pair<int, int>> descriptors = {});

}  // namespace glibra::system
