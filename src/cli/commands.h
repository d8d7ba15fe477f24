#pragma once
// The subcommands, one per file. Each adds itself to the command line and stores its exit status in `status`.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own name
class App;
}

namespace glibra::cli {

// Exit statuses. If several apply, the largest is used.
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

// Names, messages and text of scenes go to a terminal or a log only through these four: what a terminal would
// obey is written out (base::printableText).

/// The lines to print for diagnostics, with colours if `color`.
std::string printable(const Diagnostics& diagnostics, bool color);
/// Prints diagnostics to standard error, with colours if it is a terminal.
void print(const Diagnostics& diagnostics);
/// Prints a line to standard error.
void printLine(std::string_view text);
/// Prints "glibra: error: WHY" to standard error.
void printError(std::string_view why);

/// The folders of an environment variable, which are separated by colons.
std::vector<std::filesystem::path> foldersIn(const char* variable);
/// The folders of the environment variable GLIBRA_PATH.
std::vector<std::filesystem::path> libraryRoots();

}  // namespace glibra::cli
