#pragma once
// The subcommands, one per file. Each adds itself to the program's command line and stores its exit status in
// `status`.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::cli {

class CommandLine;

// Exit statuses. If several apply, the largest is used.
inline constexpr int kDone = 0;
inline constexpr int kDiffers = 1;
inline constexpr int kWrongUsage = 2;
inline constexpr int kSceneIsWrong = 3;
inline constexpr int kNoDriver = 4;

void addRender(CommandLine& program, int& status);
void addTest(CommandLine& program, int& status);
void addCheck(CommandLine& program, int& status);
void addCompare(CommandLine& program, int& status);
void addView(CommandLine& program, int& status);
void addNoise(CommandLine& program, int& status);
void addBench(CommandLine& program, int& status);
void addInfo(CommandLine& program, int& status);
void addLanguage(CommandLine& program, int& status);

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
