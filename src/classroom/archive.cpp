#include "classroom/archive.h"

#include <fmt/format.h>
#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <optional>
#include <set>
#include <system_error>
#include <type_traits>
#include <vector>

#include "glib/text.h"
#include "system/folder.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kEncrypted = 1U;
constexpr std::size_t kLongestPath = 1'000;
constexpr int kDeepestEntry = 32;
constexpr unsigned kStored = 0;

struct CloseArchive {
    void operator()(void* file) const { unzClose(file); }
};
using Archive = std::unique_ptr<std::remove_pointer_t<unzFile>, CloseArchive>;

std::ifstream& streamOf(void* file) {
    auto& stream = *static_cast<std::ifstream*>(file);
    stream.clear();
    return stream;
}

/// What minizip reads an archive with. It is given a path: its own functions take names of bytes alone.
zlib_filefunc64_def fileFunctions() {
    zlib_filefunc64_def functions{};
    functions.zopen64_file = [](void*, const void* path, int) -> void* {
        auto file = std::make_unique<std::ifstream>(*static_cast<const fs::path*>(path), std::ios::binary);
        return *file ? file.release() : nullptr;
    };
    functions.zread_file = [](void*, void* file, void* to, uLong size) {
        return static_cast<uLong>(
            streamOf(file).read(static_cast<char*>(to), static_cast<std::streamsize>(size)).gcount());
    };
    functions.ztell64_file = [](void*, void* file) { return static_cast<ZPOS64_T>(streamOf(file).tellg()); };
    functions.zseek64_file = [](void*, void* file, ZPOS64_T offset, int origin) -> long {
        const auto from = origin == ZLIB_FILEFUNC_SEEK_SET   ? std::ios::beg
                          : origin == ZLIB_FILEFUNC_SEEK_CUR ? std::ios::cur
                                                             : std::ios::end;
        return streamOf(file).seekg(static_cast<std::streamoff>(offset), from) ? 0 : -1;
    };
    functions.zclose_file = [](void*, void* file) {
        delete static_cast<std::ifstream*>(file);
        return 0;
    };
    functions.zerror_file = [](void*, void*) { return 0; };
    return functions;
}

/// The path of an entry below the folder; nothing for one that is left out. Windows writes backslashes.
std::optional<fs::path> pathOf(std::string name) {
    std::ranges::replace(name, '\\', '/');
    if (name.empty() || name.front() == '/' || name.find('\0') != std::string::npos) return std::nullopt;
    fs::path path;
    int depth = 0;
    for (const fs::path& each : fs::path(name)) {
        const std::string part = each.generic_string();
        if (part.empty() || part == ".") continue;
        if (part.front() == '.' || part == "__MACOSX" || part.size() > 255 || ++depth > kDeepestEntry ||
            !system::isPlainName(part))
            return std::nullopt;
        path /= each;
    }
    if (path.empty()) return std::nullopt;
    return path;
}

/// True for the entry of a link: Unix keeps the mode in the upper half.
bool isLink(const unz_file_info64& info) {
    constexpr unsigned kUnix = 3, kFormat = 0170000, kLink = 0120000;
    return (info.version >> 8U) == kUnix && ((info.external_fa >> 16U) & kFormat) == kLink;
}

std::string megabytes(std::uint64_t bytes) {
    return fmt::format("{} MB", std::max<std::uint64_t>(1, bytes >> 20U));
}

/// Writes the current entry. Returns what went wrong.
std::string writeEntry(unzFile file, const fs::path& to, UnpackLimits& limits, std::uint64_t allowed) {
    std::error_code failure;
    fs::create_directories(to.parent_path(), failure);
    std::ofstream out(to, std::ios::binary | std::ios::trunc);
    if (!out) return {};  // a file of this name is a folder already; the scene misses it and says so
    if (unzOpenCurrentFile(file) != UNZ_OK)
        return fmt::format("the zip file is damaged at '{}'", to.filename().generic_string());
    std::vector<char> buffer(std::size_t{1} << 16U);
    for (;;) {
        const int count = unzReadCurrentFile(file, buffer.data(), static_cast<unsigned>(buffer.size()));
        if (count == 0) break;
        const bool isDamaged = count < 0;
        if (isDamaged || static_cast<std::uint64_t>(count) > limits.bytes) {
            unzCloseCurrentFile(file);
            return isDamaged ? fmt::format("the zip file is damaged at '{}'", to.filename().generic_string())
                             : fmt::format("the zip file unpacks to more than {}", megabytes(allowed));
        }
        limits.bytes -= static_cast<std::uint64_t>(count);
        out.write(buffer.data(), count);
    }
    if (unzCloseCurrentFile(file) != UNZ_OK)
        return fmt::format("the zip file is damaged at '{}': its checksum is wrong",
                           to.filename().generic_string());
    out.close();
    return out ? std::string() : fmt::format("cannot write '{}'", to.generic_string());
}

}  // namespace

bool isArchive(const fs::path& file) {
    return glib::sameWord(file.extension().generic_string(), ".zip");
}

std::string unpackArchive(const fs::path& archive, const fs::path& into, UnpackLimits& limits) {
    const std::uint64_t allowed = limits.bytes;
    const std::size_t allowedEntries = limits.entries;
    std::set<fs::path> folders{{}};
    // False: there are more files and folders than may be made.
    const auto count = [&](fs::path path) {
        std::size_t made = 1;
        while (folders.insert(path = path.parent_path()).second) ++made;
        if (made > limits.entries) return false;
        limits.entries -= made;
        return true;
    };
    zlib_filefunc64_def functions = fileFunctions();
    const Archive file(unzOpen2_64(&archive, &functions));
    if (!file) return fmt::format("'{}' is no zip file", archive.filename().generic_string());
    int status = unzGoToFirstFile(file.get());
    if (status == UNZ_END_OF_LIST_OF_FILE) return {};
    for (; status == UNZ_OK; status = unzGoToNextFile(file.get())) {
        unz_file_info64 info{};
        std::array<char, kLongestPath + 1> name{};
        if (unzGetCurrentFileInfo64(file.get(), &info, name.data(), kLongestPath, nullptr, 0, nullptr, 0) !=
            UNZ_OK)
            return "the zip file is damaged";
        const std::string text(name.data(), std::min<std::size_t>(info.size_filename, kLongestPath));
        const std::optional<fs::path> path =
            info.size_filename >= kLongestPath || isLink(info) ? std::nullopt : pathOf(text);
        if (!count(path.value_or(fs::path())))
            return fmt::format("the zip file has more than {} files and folders", allowedEntries);
        if (!path) continue;
        if (text.back() == '/' || text.back() == '\\') continue;
        if ((info.flag & kEncrypted) != 0) return "the zip file is encrypted";
        // minizip gives the packed bytes of some that it does not know.
        if (info.compression_method != kStored && info.compression_method != Z_DEFLATED)
            return fmt::format("'{}' in the zip file is packed in a way that is not known",
                               path->filename().generic_string());
        if (std::string problem = writeEntry(file.get(), into / *path, limits, allowed); !problem.empty())
            return problem;
    }
    return status == UNZ_END_OF_LIST_OF_FILE ? std::string() : "the zip file is damaged";
}

}  // namespace glibra::classroom
