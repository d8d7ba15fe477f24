#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "base/utf8.h"
#include "cli/commands.h"

namespace glibra::cli {

std::string printable(const Diagnostics& diagnostics, bool color) {
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
    }
    return text;
}

void print(const Diagnostics& diagnostics) {
    const std::string text = printable(diagnostics, ::isatty(STDERR_FILENO) == 1);
    std::fwrite(text.data(), 1, text.size(), stderr);
}

void printLine(std::string_view text) {
    const std::string line = base::printableText(text) + '\n';
    std::fwrite(line.data(), 1, line.size(), stderr);
}

void printError(std::string_view why) {
    printLine("glibra: error: " + std::string(why));
}

std::vector<std::filesystem::path> foldersIn(const char* variable) {
    std::vector<std::filesystem::path> folders;
    const char* value = std::getenv(variable);
    std::string_view rest = value ? value : "";
    while (!rest.empty()) {
        const std::size_t colon = rest.find(':');
        if (const std::string_view folder = rest.substr(0, colon); !folder.empty())
            folders.emplace_back(folder);
        if (colon == std::string_view::npos) break;
        rest.remove_prefix(colon + 1);
    }
    return folders;
}

std::vector<std::filesystem::path> libraryRoots() {
    return foldersIn("GLIBRA_PATH");
}

}  // namespace glibra::cli
