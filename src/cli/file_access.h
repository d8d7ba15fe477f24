#pragma once
// Which files commands and their workers may read and write.

#include <glibra/diagnostic.h>
#include <glibra/driver.h>
#include <glibra/render.h>

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/workers.h"
#include "cli/command_line.h"
#include "cli/suite_options.h"
#include "image/file.h"
#include "suite/run/fingerprint.h"
#include "system/sandbox.h"

namespace glibra::cli {

// No command writes over a file that it reads.

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

// --untrusted: the processes that read scenes of strangers are confined to what they need (system/sandbox.h).

/// Adds --untrusted.
void addUntrustedOption(CommandLine& command, bool& to);

/// Prepares this process for confined workers: their driver has no cache on disk. Returns false if the system
/// has no sandbox; the reason has been printed, and the exit status is kNoDriver.
bool prepareUntrusted();

/// What workers need that draw these scenes: the scenes' folders, the library folders that the file look-up
/// searches, the image module, and the graphics devices unless the driver draws by software. A folder of the
/// library that is reached through a link, below a root, is left out, and file-W18 is printed.
system::Sandbox sandboxOf(const std::vector<std::string>& scenes, const RenderOptions& options,
                          Driver driver);

/// The same for suites; their workers write only into `folders`. A suite may have been written by a stranger
/// too, so its scenes, goldens and libraries must lie, without links, below its own folder or the current
/// one; `goldens` is a folder that the command line names. Without a value, the reason has been printed, and
/// the exit status is kSceneIsWrong.
std::optional<system::Sandbox> sandboxOf(const Selection& selection, Driver driver,
                                         const std::filesystem::path& goldens,
                                         const std::vector<system::Reach>& folders);

/// Makes the folders that workers write to, because a sandbox leaves out what does not exist when the workers
/// start.
void makeWritableFolders(const system::Sandbox& sandbox);

/// A new hidden folder, the only one that confined workers of `glibra render` write to. Their files are moved
/// out of it when they are complete. The frames of a film are there, too. It is removed with the object.
class StagingFolder {
  public:
    /// Makes the folder inside of this one, under a name that nothing has.
    explicit StagingFolder(const std::filesystem::path& parent);
    StagingFolder(const StagingFolder&) = delete;
    StagingFolder& operator=(const StagingFolder&) = delete;
    ~StagingFolder();

    /// Empty if it could not be made.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Where the worker of a piece writes the file that will be `target`.
    [[nodiscard]] std::filesystem::path fileOf(std::size_t piece, const std::filesystem::path& target) const;
    /// Where that file is, if the worker has written it as an ordinary file.
    [[nodiscard]] std::optional<std::filesystem::path> find(std::size_t piece,
                                                            const std::filesystem::path& target) const;
    /// Moves the file to its place, if there is one. Only ordinary files are moved, and only such are
    /// replaced. Empty on success, otherwise one file-E10.
    [[nodiscard]] Diagnostics deliver(std::size_t piece, const std::filesystem::path& target,
                                      image::NamedBy named) const;

  private:
    std::filesystem::path path_;
};

}  // namespace glibra::cli
