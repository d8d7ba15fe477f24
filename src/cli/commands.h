#pragma once
// The subcommands, one file each. Each adds itself to the command line and leaves its exit status in
// `status`.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <map>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own name
class App;
}

namespace glibra::cli {

// Exit statuses; of several the largest counts.
inline constexpr int kDone = 0;
inline constexpr int kDiffers = 1;
inline constexpr int kWrongUsage = 2;
inline constexpr int kSceneIsWrong = 3;
inline constexpr int kNoDriver = 4;

void addRender(CLI::App& app, int& status);
void addTest(CLI::App& app, int& status);
void addCheck(CLI::App& app, int& status);
void addCompare(CLI::App& app, int& status);
void addView(CLI::App& app, int& status);
void addNoise(CLI::App& app, int& status);
void addBench(CLI::App& app, int& status);
void addInfo(CLI::App& app, int& status);
void addLanguage(CLI::App& app, int& status);

/// --scene-transform, --eye-transform and the other options of a window's view.
void addViewOptions(CLI::App& command, ViewState& view);

/// --max-error and --override-counts.
void addBudgetOptions(CLI::App& command, RenderOptions& options);

/// Words of --driver.
inline const std::map<std::string, Driver> kDriversByWord(kDriverWords.begin(), kDriverWords.end());

/// The lines to print, in colour if `color`.
std::string printable(const Diagnostics& diagnostics, bool color);
/// Prints to standard error, in colour if that is a terminal.
void print(const Diagnostics& diagnostics);
/// Folders of the environment variable GLIBRA_PATH.
std::vector<std::filesystem::path> libraryRoots();

}  // namespace glibra::cli
