#include "image/file.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <ctime>
#include <limits>
#include <new>
#include <string_view>
#include <system_error>

#include "base/text.h"
#include "system/folder.h"
#include "system/process.h"

namespace glibra::image {

std::optional<Diagnostic> checkSize(std::uint64_t width, std::uint64_t height, std::uint64_t bytesPerPixel,
                                    const Limits& limits, const FileLabel& label) {
    const auto side = static_cast<std::uint64_t>(limits.side);
    if (width > side || height > side)
        return diagnose(
            "file-E09",
            fmt::format("'{}' has {} x {} pixels, the limit is {} per side", label.name, width, height, side),
            label.place);
    const std::uint64_t bytes = width * height * bytesPerPixel;
    if (bytes > limits.texelBytes)
        return diagnose(
            "file-E09",
            fmt::format("'{}' has {} of pixels ({} x {}), the limit is {}", label.name,
                        base::readableBytes(bytes), width, height, base::readableBytes(limits.texelBytes)),
            label.place);
    return checkSceneBytes(bytes, limits, fmt::format("'{}'", label.name), label.place);
}

std::optional<Diagnostic> checkSceneBytes(std::uint64_t bytes, const Limits& limits, const std::string& what,
                                          const Place& place) {
    if (bytes <= limits.sceneBytesLeft) return std::nullopt;
    return diagnose(
        "draw-E08",
        fmt::format("{} needs {}, but the textures of a scene may have {} together, and {} are left", what,
                    base::readableBytes(bytes), base::readableBytes(kSceneTexelBytes),
                    base::readableBytes(limits.sceneBytesLeft)),
        place);
}

std::optional<Diagnostic> checkInflation(std::uint64_t width, std::uint64_t height, std::uint64_t fileBytes,
                                         const FileLabel& label) {
    // A blank fax of 8192 x 8192 pixels may have 1 KB, so pictures up to this size pass. Beyond it, a byte of
    // TIFF with LZW holds 21,845 pixels at most, and every other common packing less.
    constexpr std::uint64_t kAlwaysPass = std::uint64_t{8192} * 8192;
    constexpr std::uint64_t kMostPerByte = 21'845;
    if (width * height <= kAlwaysPass || width * height / kMostPerByte <= fileBytes) return std::nullopt;
    return damaged(label, fmt::format("{} bytes cannot hold {} x {} pixels", fileBytes, width, height));
}

std::optional<Diagnostic> checkPacked(std::uint64_t width, std::uint64_t height, std::uint64_t bytesPerPixel,
                                      std::uint64_t fileBytes, const Limits& limits, const FileLabel& label) {
    if (auto tooLarge = checkSize(width, height, bytesPerPixel, limits, label)) return tooLarge;
    return checkInflation(width, height, fileBytes, label);
}

Diagnostic damaged(const FileLabel& label, const std::string& what) {
    return diagnose("file-E04", fmt::format("'{}': {}", label.name, what), label.place);
}

Diagnostic endsEarly(const FileLabel& label, std::uint64_t rows, std::uint64_t height) {
    return damaged(label, fmt::format("pixel data end after row {} of {}", rows, height));
}

namespace {

namespace fs = std::filesystem;
using system::FileKind;
using system::Links;

/// The system's text for an error number, as part of a sentence.
std::string reason(int number) {
    std::string text = std::generic_category().message(number);
    if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
    return text;
}

/// The path that will be replaced: the target of a link, otherwise the path itself.
fs::path resolved(const fs::path& path) {
    std::error_code failed;
    if (!fs::is_symlink(path, failed)) return path;
    const fs::path target = fs::weakly_canonical(path, failed);
    return failed ? path : target;
}

/// True for a link that leads to itself. Nothing can be written through it, and it is not replaced.
bool leadsNowhere(const fs::path& path, NamedBy named) {
    system::FileFacts facts;
    return named == NamedBy::user && factsOf(path, Links::followed, facts) == ELOOP;
}

/// True for a file that keeps its owner, its names and its access list only if it is written over.
bool mustStay(const fs::path& target, NamedBy named) {
    return named == NamedBy::user && system::mustStay(target);
}

/// True if an error number of writeOver says that the file may only be replaced.
bool mayNotWrite(int number) {
    return number == EACCES || number == EPERM;
}

}  // namespace

Result<std::vector<std::byte>> readFile(const base::FileSource& source, const FileLabel& label,
                                        std::uint64_t largest) {
    const auto unreadable = [&](const std::string& why) {
        return diagnose("file-E14", fmt::format("cannot read '{}': {}", label.name, why), label.place);
    };
    const auto wrongSize = [&](std::uint64_t size) -> std::optional<Diagnostic> {
        if (size == 0) return diagnose("file-E02", fmt::format("'{}' is empty", label.name), label.place);
        if (size <= largest) return std::nullopt;
        return diagnose("file-E09",
                        fmt::format("'{}' has {}, the limit is {}", label.name, base::readableBytes(size),
                                    base::readableBytes(largest)),
                        label.place);
    };
    if (source.content) {
        if (auto wrong = wrongSize(source.content->size())) return std::move(*wrong);
        const auto* const begin = reinterpret_cast<const std::byte*>(source.content->data());
        return std::vector<std::byte>(begin, begin + source.content->size());
    }
    const system::File file = system::openToRead(source.path, Links::followed);
    int failed = file ? 0 : errno;
    if (failed == ENOENT || failed == ENOTDIR)
        return about(diagnose("file-E01", fmt::format("cannot find '{}'", label.name), label.place),
                     label.name);
    system::FileFacts facts;
    if (failed == 0) failed = factsOf(file, facts);
    if (failed != 0) return unreadable(reason(failed));
    if (facts.kind == FileKind::folder) return unreadable("it is a folder");
    if (facts.kind != FileKind::regular) return unreadable("it is not an ordinary file");
    if (auto wrong = wrongSize(facts.size)) return std::move(*wrong);

    std::vector<std::byte> bytes;
    try {
        system::reserveLarge(bytes, facts.size);
        bytes.resize(facts.size);
    } catch (const std::bad_alloc&) {
        return unreadable("there is not enough memory");
    }
    // Fewer if the file has become shorter meanwhile; the reader of its format reports that.
    std::size_t have = 0;
    if (const int problem = readFull(file, bytes, have); problem != 0) return unreadable(reason(problem));
    bytes.resize(have);
    return bytes;
}

Diagnostic cannotWrite(const fs::path& path, const std::string& why) {
    return diagnose("file-E10", fmt::format("cannot write '{}': {}", path.generic_string(), why));
}

TemporaryFile::TemporaryFile(const fs::path& target, NamedBy named)
    : target_(named == NamedBy::user ? resolved(target) : target), named_(named) {
    if (leadsNowhere(target, named)) {
        lastError_ = ELOOP;
        return;
    }
    // mkstemp ignores the user's file mode, so names are tried one by one; the process number keeps
    // concurrent runs apart.
    constexpr int kAttempts = 1000;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        // Not the full name of the target: with the suffix, it might exceed the longest file name.
        const std::string name = fmt::format(".glibra-{}-{}.tmp{}", system::ownNumber(), attempt,
                                             target_.extension().generic_string());
        path_ = target_.parent_path() / name;
        file_ = system::makeNewFile(path_);
        if (file_) return;
        if (errno != EEXIST) break;
    }
    lastError_ = errno;
    path_.clear();
}

TemporaryFile::~TemporaryFile() {
    file_.close();
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);
}

Diagnostic TemporaryFile::failure() const {
    return cannotWrite(target_, reason(lastError_));
}

Diagnostics TemporaryFile::commit() {
    if (path_.empty()) return {failure()};
    if (const int failed = file_.close(); failed != 0) lastError_ = failed;
    if (lastError_ != 0) return {failure()};
    Diagnostics problems = moveIntoPlace(path_, target_, named_);
    if (problems.empty()) path_.clear();
    return problems;
}

Diagnostics moveIntoPlace(const fs::path& from, const fs::path& target, NamedBy named) {
    if (mustStay(target, named)) {
        const auto bytes =
            readFile(from, {target.generic_string(), {}}, std::numeric_limits<std::uint64_t>::max());
        if (!bytes) return {cannotWrite(target, bytes.diagnostics.front().text)};
        const int failed = system::writeOver(target, *bytes);
        std::error_code ignored;
        if (failed == 0) fs::remove(from, ignored);
        if (failed == 0) return {};
        if (!mayNotWrite(failed)) return {cannotWrite(target, reason(failed))};
    }
    system::keepAccess(target, from, named == NamedBy::user);
    if (const int failed = system::renameOver(from, target); failed != 0)
        return {cannotWrite(target, reason(failed))};
    return {};
}

void removeTemporaryFiles(const fs::path& folder, int process) {
    const std::string begin = fmt::format(".glibra-{}-", process);
    std::error_code ignored;
    for (const fs::directory_entry& each : base::entriesOf(folder.empty() ? "." : folder))
        if (each.path().filename().generic_string().starts_with(begin)) fs::remove(each.path(), ignored);
}

void removeAbandonedFiles(const fs::path& folder) {
    constexpr std::int64_t kAge = 60, kFolderAge = 86'400;  // nothing may be new in a folder for hours
    constexpr std::string_view kBegin = ".glibra-";
    for (const fs::directory_entry& each : base::entriesOf(folder.empty() ? "." : folder)) {
        const std::string name = each.path().filename().generic_string();
        if (!name.starts_with(kBegin)) continue;
        int process = 0, attempt = 0;
        const char* const last = name.data() + name.size();
        const auto [after, wrong] = std::from_chars(name.data() + kBegin.size(), last, process);
        if (wrong != std::errc{} || process <= 0 || after == last || *after != '-') continue;
        const auto [rest, alsoWrong] = std::from_chars(after + 1, last, attempt);
        const bool isFolder = std::string_view(after, last).starts_with(kStaging);
        if (!isFolder && (alsoWrong != std::errc{} || !std::string_view(rest, last).starts_with(".tmp")))
            continue;
        system::FileFacts facts;
        factsOf(each.path(), Links::notFollowed, facts);
        if (facts.kind != (isFolder ? FileKind::folder : FileKind::regular) || !facts.isOwn ||
            static_cast<std::int64_t>(std::time(nullptr)) - facts.seconds < (isFolder ? kFolderAge : kAge) ||
            system::isRunning(process))
            continue;
        std::error_code ignored;
        fs::remove_all(each.path(), ignored);
    }
}

Diagnostics writeFileAtomically(const fs::path& path, std::span<const std::byte> bytes, NamedBy named) {
    const bool isUsers = named == NamedBy::user;
    const FileKind kind = system::kindOf(path, isUsers ? Links::followed : Links::notFollowed);
    if (leadsNowhere(path, named)) return {cannotWrite(path, reason(ELOOP))};
    if (kind == FileKind::folder) return {cannotWrite(path, "it is a folder")};
    if (isUsers && kind == FileKind::other) {
        const system::File device = system::openToOverwrite(path);
        const int failed = device ? writeAll(device, bytes) : errno;
        if (failed != 0) return {cannotWrite(path, reason(failed))};
        return {};
    }
    const fs::path target = isUsers ? resolved(path) : path;
    int written = mustStay(target, named) ? system::writeOver(target, bytes) : EACCES;
    if (mayNotWrite(written)) written = system::replaceUnnamed(target, bytes, isUsers);
    if (written == 0) return {};
    if (written != ENOTSUP) return {cannotWrite(path, reason(written))};
    TemporaryFile temporary(path, named);
    if (!temporary.file()) return {temporary.failure()};
    if (const int failed = writeAll(temporary.file(), bytes); failed != 0)
        return {cannotWrite(path, reason(failed))};
    return temporary.commit();
}

}  // namespace glibra::image
