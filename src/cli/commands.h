#pragma once
// The subcommands, one per file. Each adds itself to the program's command line and stores its exit status in
// `status`.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <string>
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

/// The lines to print for diagnostics, with colours if `color`.
std::string printable(const Diagnostics& diagnostics, bool color);
/// Prints diagnostics to standard error, with colours if it is a terminal.
void print(const Diagnostics& diagnostics);
/// The folders of the environment variable GLIBRA_PATH.
std::vector<std::filesystem::path> libraryRoots();

}  // namespace glibra::cli
