#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "base/files.h"
#include "base/utf8.h"
#include "cli/commands.h"
#include "cli/scene_arguments.h"
#include "scene/file_lookup.h"
#include "system/places.h"

namespace glibra::cli {

namespace {

std::string_view variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

/// The part of a long line that is shown, so that it fits on a line of a terminal.
constexpr std::size_t kShownBytes = 100;

/// The line with its number, and a caret below the column; without control characters.
std::string excerpt(int number, std::string_view line, int column) {
    const auto isInside = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    std::size_t caret = std::min(static_cast<std::size_t>(std::max(column, 1)) - 1, line.size());
    std::size_t begin = caret > kShownBytes * 3 / 4 ? caret - kShownBytes * 3 / 4 : 0;
    while (begin > 0 && isInside(line[begin])) --begin;
    std::size_t end = std::min(line.size(), begin + kShownBytes);
    while (end > begin && end < line.size() && isInside(line[end])) --end;
    caret = std::min(caret, end);
    const std::string before = base::printableText(line.substr(begin, caret - begin));
    const auto width = static_cast<std::size_t>(
        std::count_if(before.begin(), before.end(), [&](char c) { return !isInside(c); }));
    return fmt::format("{:>5} | {}{}\n{:5} | {:{}}^\n", number, before,
                       base::printableText(line.substr(caret, end - caret)), "", "", width);
}

}  // namespace

bool hasColor(system::Standard stream) {
    if (!variable("NO_COLOR").empty()) return false;  // https://no-color.org
    if (const std::string_view forced = variable("CLICOLOR_FORCE"); !forced.empty() && forced != "0")
        return true;
    return variable("CLICOLOR") != "0" && variable("TERM") != "dumb" && isTerminal(stream);
}

SourceLines linesOf(const Diagnostics& diagnostics, const std::optional<std::string>& standardInput) {
    constexpr std::size_t kMostLines = 50, kMostBytes = 4096;
    constexpr std::uintmax_t kLargestFile = std::uintmax_t{4} << 20;
    SourceLines lines;
    for (const Diagnostic& each : diagnostics) {
        const bool isOfText = each.id.starts_with("glib-") || each.id.starts_with("glsl-");
        if (each.severity != Severity::error || each.place.line < 1 || !isOfText ||
            each.text.starts_with(scene::kHiddenText))
            continue;
        if (lines.size() == kMostLines) break;
        std::string line;
        const auto take = [&](std::istream& file) {
            for (int number = 0; number < each.place.line && std::getline(file, line);) ++number;
        };
        if (standardInput && each.place.file == kStandardInput) {
            std::istringstream text(*standardInput);
            take(text);
        } else {
            std::error_code failure;
            const std::filesystem::path path = each.place.file;
            if (!std::filesystem::is_regular_file(path, failure) ||
                std::filesystem::file_size(path, failure) > kLargestFile || failure)
                continue;
            std::ifstream file(path, std::ios::binary);
            take(file);
        }
        while (line.ends_with('\r')) line.pop_back();
        line.resize(std::min(line.size(), kMostBytes));
        if (!line.empty()) lines[{each.place.file, each.place.line}] = std::move(line);
    }
    return lines;
}

std::string printable(const Diagnostics& diagnostics, bool color, const SourceLines& lines) {
    std::string text;
    for (const Diagnostic& each : diagnostics) {
        std::string line = base::printableText(toString(each));
        if (color) {
            const std::string word = std::string(name(each.severity)) + ": ";
            const char* shade = each.severity == Severity::error     ? "\033[1;31m"
                                : each.severity == Severity::warning ? "\033[1;35m"
                                                                     : "\033[1;36m";
            const std::size_t at = line.find(word);
            if (at != std::string::npos) line.replace(at, word.size(), shade + word + "\033[0m");
        }
        text += line;
        text += '\n';
        const auto quoted = lines.find({each.place.file, each.place.line});
        if (each.severity == Severity::error && quoted != lines.end())
            text += excerpt(each.place.line, quoted->second, each.place.column);
    }
    return text;
}

void print(const Diagnostics& diagnostics, const SourceLines& lines) {
    const std::string text = printable(diagnostics, hasColor(system::Standard::error), lines);
    std::fwrite(text.data(), 1, text.size(), stderr);
}

bool printErrors(const Diagnostics& diagnostics) {
    print(diagnostics);
    return hasError(diagnostics);
}

void printLine(std::string_view text) {
    const std::string line = base::printableText(text) + '\n';
    std::fwrite(line.data(), 1, line.size(), stderr);
}

void printNote(std::string_view why) {
    printLine("glibra: note: " + std::string(why));
}

void printError(std::string_view why) {
    printLine("glibra: error: " + std::string(why));
}

int refuse(std::string_view why) {
    printError(why);
    return kWrongUsage;
}

int endProgram(int status) {
    const std::string problem = base::endStandardOutput();
    if (problem.empty()) return status;
    printError("cannot write to standard output: " + problem);
    return std::max(status, kSceneIsWrong);
}

int failProgram(std::string_view why) {
    const int status = endProgram(kDone);
    if (status == kDone) printError(why);
    return kSceneIsWrong;
}

std::vector<std::filesystem::path> libraryRoots() {
    return system::foldersIn("GLIBRA_PATH");
}

}  // namespace glibra::cli
