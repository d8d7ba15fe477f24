// What is the same on all systems.

#include <filesystem>
#include <span>
#include <utility>

#include "system/child_process.h"
#include "system/file.h"
#include "system/folder.h"
#include "system/process.h"

namespace glibra::system {

namespace fs = std::filesystem;

File& File::operator=(File&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
}

FileKind kindOf(const fs::path& path, Links links) {
    FileFacts facts;
    factsOf(path, links, facts);
    return facts.kind;
}

FileIdentity identityOf(const fs::path& path) {
    FileFacts facts;
    factsOf(path, Links::followed, facts);
    return {facts.device, facts.number, facts.size, facts.seconds, facts.nanoseconds};
}

fs::path wholePath(const fs::path& path) {
    std::error_code failure;
    return asInFolders(fs::absolute(path, failure).lexically_normal());
}

Process& Process::operator=(Process&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
}

SharedFile::SharedFile(SharedFile&& other) noexcept
    : file_(std::move(other.file_)), bytes_(std::exchange(other.bytes_, {})) {}

SharedFile& SharedFile::operator=(SharedFile&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(bytes_, other.bytes_);
    return *this;
}

void end(ChildProcess& child) {
    kill(child.process);
    waitFor(child.process);
    child = ChildProcess();
}

void send(const Worker& worker, std::span<const std::byte> bytes) {
    writeAll(worker.requests, bytes);
}

End end(Worker& worker) {
    worker.requests.close();
    worker.answers.close();
    return waitFor(worker.process);
}

}  // namespace glibra::system
