// What is the same on all systems.

#include <algorithm>
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

/// The path with links followed, as far as it exists; empty if they cannot be.
static fs::path withoutLinks(const fs::path& path) {
    std::error_code failure;
    const fs::path found = fs::weakly_canonical(fs::absolute(path.empty() ? "." : path, failure), failure);
    if (failure) return {};
    return asInFolders(found.has_filename() || !found.has_relative_path() ? found : found.parent_path());
}

fs::path realPath(const fs::path& path) {
    const fs::path found = withoutLinks(path);
    return found.empty() ? wholePath(path) : found;
}

bool isBelow(const fs::path& path, const fs::path& folder) {
    const fs::path inside = withoutLinks(path), outside = withoutLinks(folder);
    return !inside.empty() && !outside.empty() &&
           std::mismatch(outside.begin(), outside.end(), inside.begin(), inside.end()).first == outside.end();
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
