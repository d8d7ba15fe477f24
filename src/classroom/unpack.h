#pragma once
// Unpacks the zip files of strangers, with minizip, in worker processes.

#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "classroom/submissions.h"
#include "system/sandbox.h"

namespace glibra::classroom {

/// What one submission may unpack. A zip file may promise, and hold, terabytes.
struct UnpackLimits {
    std::uint64_t bytes = std::uint64_t{256} << 20U;
    std::size_t entries = 20'000;  ///< files, and folders that are made for them
};

/// The work of such a process: unpacks a zip file into a folder, which must exist, and takes what it uses
/// from `limits`. Only ordinary files are made, with names that lead downwards; links, hidden files and what
/// macOS adds ("__MACOSX") are left out. Returns an empty text, or why the file cannot be unpacked: it is no
/// zip file, is encrypted, ends too early, or reaches a limit; then the folder may have a part of it.
std::string unpackArchive(const std::filesystem::path& archive, const std::filesystem::path& into,
                          UnpackLimits& limits);

/// Where zip files are unpacked, and who does it.
struct UnpackOptions {
    std::filesystem::path site;  ///< SITE/unpacked/NAME is the folder of a submission
    double timeout = 0;          ///< seconds for each submission; 0: no limit
    const system::Sandbox* sandbox = nullptr;
    std::function<bool()> stop{};
    UnpackLimits ofClass{std::uint64_t{4} << 30U, 200'000};  ///< all together; each has its own, too
};

inline constexpr const char* kUnpacked = "unpacked";
inline constexpr const char* kExport = "export";

/// Unpacks the zip file in which a learning platform exports all submissions to SITE/export. Returns that
/// folder, or the only folder in it if that is not itself a submission. Errors: file-E10, or why it cannot be
/// unpacked.
Result<std::filesystem::path> unpackExport(const std::filesystem::path& archive,
                                           const UnpackOptions& options);

/// Makes the folders of the submissions that have `parts` and finds their scenes. Those that cannot be
/// unpacked have a `problem`, and so have those that do not fit beside those before them. Removes what an
/// earlier run has unpacked. Error: file-E10.
Diagnostics unpackSubmissions(Submissions& submissions, const SubmissionOptions& find,
                              const UnpackOptions& options);

}  // namespace glibra::classroom
