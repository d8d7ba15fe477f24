#pragma once
// No command writes over a file that it reads.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/workers.h"
#include "cli/suite_options.h"
#include "suite/run/fingerprint.h"

namespace glibra::cli {

/// Files that a command reads, and what they are to it.
class ReadFiles {
  public:
    /// `what` is the file in words, as "the scene 'a.glib' reads it".
    void add(const std::filesystem::path& file, std::string_view what);
    /// All files that scenes of a selection read, and its suites.
    void add(const Selection& selection, const suite::ShotInputs& inputs);

    /// file-E13 if writing the file would replace one of them; `option` names who writes, as "--junit".
    /// Folders on the way may be links.
    [[nodiscard]] Diagnostics overwrittenBy(const std::filesystem::path& file, std::string_view option) const;

  private:
    std::map<std::filesystem::path, std::string> files_;  ///< by their place
};

/// All files that scenes of a command read, and the scenes themselves. The scenes are read in worker
/// processes.
ReadFiles filesReadBy(std::span<const std::string> scenes, const std::optional<std::string>& standardInput,
                      const RenderOptions& options, const base::WorkerOptions& workers);

/// file-E10 for a folder whose name is this program's choice, and which is a link; `option` names it.
Diagnostic linkedFolder(const std::filesystem::path& folder, std::string_view option);

/// True if one of the files exists, so that writing them all could replace something.
bool anyExists(std::span<const std::filesystem::path> files);

}  // namespace glibra::cli
