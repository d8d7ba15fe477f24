// A page has one thread and one process, and neither a disk nor libraries nor an environment. The functions
// of this room that need one of these fail, as their headers say.

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "system/child_process.h"
#include "system/file.h"
#include "system/folder.h"
#include "system/library.h"
#include "system/memory.h"
#include "system/places.h"
#include "system/process.h"

namespace glibra::system {
namespace {

namespace fs = std::filesystem;

File noFile(int why = ENOSYS) {
    errno = why;
    return {};
}

}  // namespace

// file.h and folder.h. Nothing is opened: the contents of a page's files are given by a FileReader.

File::~File() = default;
int File::close() {
    return 0;
}
int factsOf(const File& /*file*/, FileFacts& facts) {
    facts = {};
    return EBADF;
}
File openToRead(const fs::path& /*path*/, Links /*links*/) {
    return noFile(ENOENT);
}
int readFull(const File& /*file*/, std::span<std::byte> /*bytes*/, std::size_t& count) {
    count = 0;
    return EBADF;
}
void reserveLarge(std::vector<std::byte>& bytes, std::size_t size) {
    bytes.reserve(size);
}

// library.h

Library Library::open(const std::string& /*name*/, When /*when*/, std::string& why) {
    why = "a page loads no libraries";
    return {};
}
void* Library::address(const char* /*name*/) const {
    return nullptr;
}
std::string moduleName(std::string_view name) {
    return std::string(name);
}
void* loadedFunction(const char* /*library*/, const char* /*name*/) {
    return nullptr;
}
fs::path fileOfThisCode() {
    return {};
}

// memory.h and places.h

SharedMemory::SharedMemory(std::size_t size) : bytes_(new std::byte[size](), size) {}
LiftedMemoryLimit::LiftedMemoryLimit() = default;
LiftedMemoryLimit::~LiftedMemoryLimit() = default;
SharedMemory::~SharedMemory() {
    delete[] bytes_.data();
}
fs::path programFile() {
    return {};
}
void setVariable(const char* /*name*/, const std::string& /*value*/, Replace /*replace*/) {}

// process.h and child_process.h

Process::~Process() = default;
void onCopy(void (* /*note*/)()) {}
bool workersAreCopies() {
    return false;
}

}  // namespace glibra::system
