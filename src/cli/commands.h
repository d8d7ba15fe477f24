#pragma once
// The subcommands. Each adds itself to the program's command line and stores its exit status in
// `status`.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "system/terminal.h"

namespace glibra::cli {

class CommandLine;
class Program;

// Exit statuses. If several apply, the largest is used.
inline constexpr int kDone = 0;
inline constexpr int kDiffers = 1;
inline constexpr int kWrongUsage = 2;
inline constexpr int kSceneIsWrong = 3;
inline constexpr int kNoDriver = 4;

void addRender(CommandLine& program, int& status);
void addTest(CommandLine& program, int& status);
void addReview(CommandLine& program, int& status);
void addClass(CommandLine& program, int& status);
void addGallery(CommandLine& program, int& status);
void addPublish(CommandLine& program, int& status);
void addCheck(CommandLine& program, int& status);
void addFormat(CommandLine& program, int& status);
void addCompare(CommandLine& program, int& status);
void addView(CommandLine& program, int& status);
void addNoise(CommandLine& program, int& status);
void addBench(CommandLine& program, int& status);
void addInfo(CommandLine& program, int& status);
void addLanguage(CommandLine& program, int& status);
void addLanguageServer(CommandLine& program, int& status);
/// `whole` is the program that `line` belongs to, which the pages describe. It must live until the line has
/// been read.
void addCompletion(CommandLine& line, const Program& whole, int& status);
void addManual(CommandLine& line, const Program& whole, int& status);

// Names, messages and text of scenes go to a terminal or a log only through these: what a terminal would
// obey is written out (base::printableText).

/// True if text for the descriptor is to have colours: it is a terminal, unless NO_COLOR, CLICOLOR=0 or
/// CLICOLOR_FORCE say otherwise.
bool hasColor(system::Standard stream);

/// Lines of source files by file and number, for diagnostics to quote.
using SourceLines = std::map<std::pair<std::string, int>, std::string>;
/// The lines that the errors name. The processes that read a scene read them too: a diagnostic of a worker
/// may name any file, so the main process must not open it. `standardInput` is the text of the scene
/// kStandardInput.
SourceLines linesOf(const Diagnostics& diagnostics, const std::optional<std::string>& standardInput = {});

/// The lines to print for diagnostics, with colours if `color`. An error whose line is among `lines` is
/// followed by it, with a caret below the column.
std::string printable(const Diagnostics& diagnostics, bool color, const SourceLines& lines = {});
/// Prints diagnostics to standard error, with colours if it has them.
void print(const Diagnostics& diagnostics, const SourceLines& lines = {});
/// The same. Returns true if one of them is an error.
bool printErrors(const Diagnostics& diagnostics);
/// Prints a line to standard error.
void printLine(std::string_view text);
/// Prints "glibra: note: WHY" to standard error.
void printNote(std::string_view why);
/// Prints "glibra: error: WHY" to standard error.
void printError(std::string_view why);
/// The same about the command line. Returns kWrongUsage.
int refuse(std::string_view why);
/// Ends a program that has this exit status: what it printed on standard output has to have arrived there, or
/// else the status is kSceneIsWrong, with a message.
int endProgram(int status);
/// Ends a program that an exception has stopped; `why` is its text. What could not be printed counts first:
/// it may be the reason. Returns kSceneIsWrong.
int failProgram(std::string_view why);

/// The folders of the environment variable GLIBRA_PATH.
std::vector<std::filesystem::path> libraryRoots();

}  // namespace glibra::cli
