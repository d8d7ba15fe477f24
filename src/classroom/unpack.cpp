#include <fmt/format.h>

#include <cstddef>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

#include "base/contained.h"
#include "base/contained_call.h"
#include "base/files.h"
#include "base/workers.h"
#include "classroom/archive.h"
#include "classroom/names.h"
#include "classroom/submissions.h"
#include "image/file.h"
#include "system/folder.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = ".made-by-glibra";
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
    if (!why.empty()) empty(folder);
    if (!why.empty())
        return withoutId(Severity::error,
                         fmt::format("cannot unpack '{}': {}", archive.generic_string(), why));
    return descended(folder);
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
