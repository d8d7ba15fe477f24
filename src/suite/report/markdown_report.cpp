#include "suite/report/markdown_report.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "base/text.h"
#include "base/utf8.h"
#include "suite/report/terminal_report.h"
#include "suite/results/figures.h"

namespace glibra::suite {
namespace {

constexpr std::size_t kMostListed = 30;
constexpr std::size_t kMostText = 30000;  // a comment on GitHub has at most 65536 characters

/// Text of a table cell: what Markdown or HTML would read as markup is written as a character reference.
std::string cell(std::string_view text) {
    std::string escaped;
    for (const char c : base::printableText(text)) {
        const bool isPlain = base::isLetter(c) || base::isDigit(c) || static_cast<unsigned char>(c) >= 0x80 ||
                             std::string_view(" .,:;/=+-%()'").find(c) != std::string_view::npos;
        escaped += isPlain ? std::string(1, c) : fmt::format("&#{};", static_cast<unsigned char>(c));
    }
    return escaped;
}

/// A path of the results folder as the end of an address.
std::string address(const std::string& path) {
    std::string encoded;
    for (const char c : path) {
        const bool isPlain = base::isOfName(c) || std::string_view("-.~/").find(c) != std::string_view::npos;
        encoded += isPlain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return encoded;
}

std::string imageTag(const std::filesystem::path& file, const std::string& at) {
    if (file.empty() || file.is_absolute()) return "";
    return fmt::format("<img src=\"{}/{}\" width=\"160\">", at, address(file.generic_string()));
}

}  // namespace

std::string toMarkdown(const RunResult& run, const MarkdownOptions& options) {
    std::string text = fmt::format("### Pictures: {}\n\n", cell(counts(run)));
    if (const std::string missing = shortfall(run); !missing.empty())
        text += fmt::format("**Incomplete:** {}\n\n", cell(missing));
    constexpr std::size_t kMostOrphans = 20;
    for (const std::string& line : orphanLines(run, kMostOrphans)) text += cell(line) + "\n\n";
    std::vector<const ShotResult*> shots;
    for (const Verdict verdict : kVerdictsByConcern)
        for (const ShotResult& each : run.shots)
            if (each.verdict == verdict && needsALook(each)) shots.push_back(&each);
    if (shots.empty()) return text;
    const bool hasPictures = !options.picturesAt.empty();
    text += hasPictures ? "| shot | | why | expected | got | difference |\n|---|---|---|---|---|---|\n"
                        : "| shot | | why |\n|---|---|---|\n";
    for (std::size_t i = 0; i < shots.size() && i < kMostListed; ++i) {
        const ShotResult& shot = *shots[i];
        text += fmt::format("| {} | {} | {} |", cell(shot.suite + "/" + shot.shot),
                            isChangedPass(shot) ? "changed" : name(shot.verdict), cell(reasonOf(shot)));
        if (hasPictures)
            for (const auto* each : {&shot.expected, &shot.got, &shot.difference})
                text += fmt::format(" {} |", imageTag(*each, options.picturesAt));
        text += "\n";
    }
    if (shots.size() > kMostListed) text += fmt::format("\n... and {} more\n", shots.size() - kMostListed);
    if (hasPictures) return text;
    // Indented, so that no line of it can end the block.
    std::string details = toText(run, TextOptions{.resultsFolder = options.results, .mapColumns = 48});
    if (details.size() > kMostText) details = details.substr(0, details.rfind('\n', kMostText)) + "\n...\n";
    text += "\n<details><summary>Heat maps</summary>\n\n    ";
    for (const char c : details) text += c == '\n' ? "\n    " : std::string(1, c);
    return text + "\n\n</details>\n";
}

}  // namespace glibra::suite
