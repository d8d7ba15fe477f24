#include "classroom/unpack.h"

#include <fmt/format.h>
#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>
#include <type_traits>
#include <vector>

#include "base/contained.h"
#include "base/contained_call.h"
#include "base/files.h"
#include "base/utf8.h"
#include "base/workers.h"
#include "classroom/names.h"
#include "glib/text.h"
#include "image/file.h"
#include "system/folder.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kEncrypted = 1U;
constexpr std::size_t kLongestPath = 1'000;
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

/// The name of an entry. Tools write UTF-8 with and without a flag for it, or code page 437 (APPNOTE.TXT,
/// D.1).
std::string nameOf(std::string_view bytes) {
    constexpr std::u16string_view kPage437 =
        u"ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀"
        u"αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u00A0";
    return base::isUtf8(bytes) ? std::string(bytes) : fromCodePage(bytes, kPage437);
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
        if (part.front() == '.' || part == "__MACOSX" || part.size() > 255 || ++depth > kDeepestFolder ||
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

constexpr const char* kFormerMark = "made-by-glibra";

/// Makes SITE/NAME anew. The mark says that a folder of this name is ours, so that nobody loses theirs.
Diagnostics makeFolder(const fs::path& site, const char* name) {
    const fs::path folder = site / name;
    const auto fail = [&](const std::string& why) {
        return Diagnostics{
            diagnose("file-E10", fmt::format("cannot write into '{}': {}", folder.generic_string(), why))};
    };
    std::error_code failure;
    const fs::file_type type = fs::symlink_status(folder, failure).type();
    if (type == fs::file_type::directory) {
        if (!fs::exists(folder / kMark, failure) && !fs::exists(folder / kFormerMark, failure) &&
            !fs::is_empty(folder, failure))
            return fail("it was not made by glibra; name another folder with -o");
        system::removeTree(folder);
    } else if (type != fs::file_type::not_found) {
        return fail("it is no folder");
    }
    const int problem = base::writeBeneath(site, fs::path(name) / kMark, {});
    return problem == 0 ? Diagnostics{} : fail(std::generic_category().message(problem));
}

/// Removes what was unpacked before something went wrong.
void empty(const fs::path& folder) {
    for (const fs::directory_entry& each : base::entriesOf(folder))
        if (each.path().filename() != kMark) system::removeTree(each.path());
}

/// Copies an ordinary file by reading and writing alone, which is all that a sandbox allows.
std::string copy(const fs::path& from, const fs::path& to, UnpackLimits& limits) {
    const auto bytes = base::bytesIn(base::openBeneath(from.parent_path(), from.filename()), limits.bytes);
    if (!bytes) return fmt::format("cannot read '{}', or it is too large", from.filename().generic_string());
    limits.bytes -= bytes->size();
    std::ofstream out(to, std::ios::binary | std::ios::trunc);
    out << base::asText(*bytes);
    out.close();
    return out ? std::string() : fmt::format("cannot write '{}'", to.generic_string());
}

std::string unpack(const Submission& submission, UnpackLimits& limits) {
    for (const Submission::Part& each : submission.parts) {
        if (isArchive(each.file)) {
            if (std::string why = unpackArchive(each.file, submission.folder, limits); !why.empty())
                return why;
            continue;
        }
        const fs::path name = fs::path(each.name).filename();
        if (!system::isPlainName(name.generic_string()) || name.generic_string().front() == '.') continue;
        if (std::string why = copy(each.file, submission.folder / name, limits); !why.empty()) return why;
    }
    return {};
}

/// The only folder in `folder`, if there is nothing else and it has no scene of its own: Gradescope puts all
/// submissions into one.
fs::path descended(const fs::path& folder) {
    std::vector<fs::path> inside;
    std::error_code failure;
    for (const fs::directory_entry& each : base::entriesOf(folder, failure))
        if (each.path().filename() != kMark) inside.push_back(each.path());
    if (failure || inside.size() != 1 ||
        fs::symlink_status(inside[0], failure).type() != fs::file_type::directory)
        return folder;
    for (const fs::directory_entry& each : base::entriesOf(inside[0]))
        if (each.path().extension() == ".glib") return folder;
    return inside[0];
}

}  // namespace

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
        const std::string text =
            nameOf({name.data(), std::min<std::size_t>(info.size_filename, kLongestPath)});
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

Result<fs::path> unpackExport(const fs::path& archive, const UnpackOptions& options) {
    if (Diagnostics problems = makeFolder(options.site, kExport); !problems.empty()) return problems;
    const fs::path folder = options.site / kExport;
    std::string why = "it could not be unpacked within the limits";
    base::runInWorkers(
        1, {.memory = base::memoryShare(1, 1), .stop = options.stop, .sandbox = options.sandbox},
        [&](std::size_t, const base::Step&) {
            UnpackLimits limits = options.ofClass;
            return unpackArchive(archive, folder, limits);
        },
        [&](std::size_t, const base::Outcome& outcome) {
            if (outcome.end == base::Outcome::End::finished) why = outcome.answer;
        },
        [](std::size_t, const std::string&) {});
    if (why.empty()) return descended(folder);
    empty(folder);
    return withoutId(Severity::error, fmt::format("cannot unpack '{}': {}", archive.generic_string(), why));
}

Diagnostics unpackSubmissions(Submissions& submissions, const SubmissionOptions& find,
                              const UnpackOptions& options) {
    std::vector<Submission*> packed;
    for (Submission& each : submissions.all)
        if (!each.parts.empty()) packed.push_back(&each);
    std::error_code failure;
    if (packed.empty() && !fs::exists(options.site / kUnpacked / kMark, failure)) return {};
    if (Diagnostics problems = makeFolder(options.site, kUnpacked); !problems.empty() || packed.empty())
        return problems;
    std::vector<std::string> names;
    for (const Submission* each : packed) names.push_back(each->name);
    names = fileNames(std::move(names));
    for (std::size_t i = 0; i < packed.size(); ++i) {
        packed[i]->folder = options.site / kUnpacked / names[i];
        fs::create_directory(packed[i]->folder, failure);
        if (failure) return {image::cannotWrite(packed[i]->folder, failure.message())};
    }
    // One after another, so that what the class may unpack goes to the same of them in every run, and no more
    // than that and one submission ever lies there. The answer has what is left of a submission's own limits.
    UnpackLimits left = options.ofClass;
    base::runInWorkers(
        packed.size(),
        {.timeout = options.timeout,
         .memory = base::memoryShare(1, 1),
         .stop = options.stop,
         .sandbox = options.sandbox},
        [&](std::size_t index, const base::Step&) {
            UnpackLimits own;
            const std::string why = unpack(*packed[index], own);
            return fmt::format("{} {} {}", own.bytes, own.entries, why);
        },
        [&](std::size_t index, const base::Outcome& outcome) {
            UnpackLimits own;
            std::istringstream answer(outcome.answer);
            std::string& why = packed[index]->problem;
            if (outcome.end != base::Outcome::End::finished || !(answer >> own.bytes >> own.entries))
                why = "the zip file could not be unpacked within the limits";
            else
                std::getline(answer.ignore(), why, '\0');
            const std::uint64_t bytes = UnpackLimits{}.bytes - own.bytes;
            const std::size_t entries = UnpackLimits{}.entries - own.entries;
            if (why.empty() && (bytes > left.bytes || entries > left.entries))
                why =
                    fmt::format("with those before it, it unpacks to more than {} MB or {} files and folders",
                                options.ofClass.bytes >> 20U, options.ofClass.entries);
            if (!why.empty()) return empty(packed[index]->folder);
            left.bytes -= bytes;
            left.entries -= entries;
        },
        [](std::size_t, const std::string&) {});
    for (Submission* each : packed)
        if (each->problem.empty()) findScene(*each, find);
    return {};
}

}  // namespace glibra::classroom
