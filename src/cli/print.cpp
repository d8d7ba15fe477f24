#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "cli/commands.h"

namespace glibra::cli {

std::string printable(const Diagnostics& diagnostics, bool color) {
    std::string text;
    for (const Diagnostic& each : diagnostics) {
        std::string line = toString(each);
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

std::vector<std::filesystem::path> libraryRoots() {
    std::vector<std::filesystem::path> roots;
    const char* variable = std::getenv("GLIBRA_PATH");
    std::string_view rest = variable ? variable : "";
    while (!rest.empty()) {
        const std::size_t colon = rest.find(':');
        if (const std::string_view folder = rest.substr(0, colon); !folder.empty())
            roots.emplace_back(folder);
        if (colon == std::string_view::npos) break;
        rest.remove_prefix(colon + 1);
    }
    return roots;
}

}  // namespace glibra::cli
