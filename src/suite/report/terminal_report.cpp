#include "suite/report/terminal_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/page_template.h"
#include "base/text.h"
#include "base/utf8.h"
#include "embedded/report_page.h"
#include "image/read.h"
#include "suite/options/option_words.h"
#include "suite/report/report_pictures.h"
#include "suite/results/results_file.h"

namespace glibra::suite {
namespace {

constexpr std::string_view kRed = "\033[1;31m", kYellow = "\033[1;33m", kGreen = "\033[1;32m",
                           kGrey = "\033[2m", kBold = "\033[1m";

class Text {
  public:
    explicit Text(const TextOptions& options) : options_(options) {}

    void shot(const ShotResult& shot, bool full) {
        const std::string_view paint = isFailure(shot.verdict) ? kRed : kYellow;
        line(painted(name(shot.verdict), paint) + " " +
             painted(base::printableText(shot.suite + "/" + shot.shot), kBold) +
             (reasonOf(shot).empty() ? "" : ": " + base::printableText(reasonOf(shot))));
        if (full) details(shot);
    }

    void line(std::string_view text) {
        all_ += text;
        all_ += '\n';
    }
    /// The goldens that --update has written, and for which drivers, in one table.
    void updates(const RunResult& run) {
        std::vector<std::array<std::string, 5>> rows;
        for (const ShotResult& shot : run.shots) {
            if (shot.verdict != Verdict::updated) continue;
            const image::Comparison& found = shot.judgement.comparison;
            const bool isCompared = found.differingPixels > 0;
            const double pixels = std::max(1., static_cast<double>(shot.width) * shot.height);
            rows.push_back(
                {base::printableText(shot.suite + "/" + shot.shot),
                 shot.goldenVariant.empty() ? "all drivers" : base::printableText(shot.goldenVariant),
                 isCompared ? fmt::format("{} ({:.3g} %)", found.differingPixels,
                                          100 * static_cast<double>(found.differingPixels) / pixels)
                            : "-",
                 isCompared ? fmt::format("{:.4g}/255", 255 * found.largest) : "-",
                 base::printableText(shot.reason)});
        }
        if (rows.empty()) return;
        line(painted(base::counted(rows.size(), "golden") + " written" +
                         (run.driver.empty() ? "" : ", on " + base::printableText(run.driver)),
                     kBold));
        rows.insert(rows.begin(), {"golden", "for", "pixels that differ", "by up to", "what"});
        std::array<std::size_t, 4> widths{};
        for (const auto& row : rows)
            for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
        for (const auto& row : rows) {
            std::string text = "   ";
            for (std::size_t i = 0; i < widths.size(); ++i)
                text += fmt::format(" {:<{}} ", row[i], widths[i]);
            line(text + " " + row.back());
        }
    }
    /// Warnings of shots that do not fail, each text once.
    void warnings(const RunResult& run) {
        struct Repeated {
            const Diagnostic* warning = nullptr;
            const ShotResult *first = nullptr, *last = nullptr;
            std::size_t shots = 0;
        };
        std::vector<Repeated> all;
        for (const ShotResult& shot : run.shots) {
            if (isFailure(shot.verdict)) continue;
            for (const Diagnostic& each : shot.diagnostics) {
                if (each.severity != Severity::warning) continue;
                const auto known = std::ranges::find_if(all, [&](const Repeated& other) {
                    return other.warning->id == each.id && other.warning->text == each.text;
                });
                if (known == all.end()) {
                    all.push_back({&each, &shot, &shot, 1});
                } else if (known->last != &shot) {
                    known->last = &shot;
                    ++known->shots;
                }
            }
        }
        constexpr std::size_t kMost = 10;
        for (std::size_t i = 0; i < std::min(all.size(), kMost); ++i)
            line(base::printableText(toString(*all[i].warning)) +
                 painted(fmt::format(" in {}, as {}/{}", base::counted(all[i].shots, "shot"),
                                     base::printableText(all[i].first->suite),
                                     base::printableText(all[i].first->shot)),
                         kGrey));
        if (all.size() > kMost) line(fmt::format("{} more warnings are not shown", all.size() - kMost));
    }
    [[nodiscard]] std::string painted(std::string_view text, std::string_view paint) const {
        if (!options_.color) return std::string(text);
        return fmt::format("{}{}\033[0m", paint, text);
    }
    std::string take() { return std::move(all_); }

  private:
    void details(const ShotResult& shot) {
        for (const Diagnostic& each : shot.diagnostics) line("    " + base::printableText(toString(each)));
        for (const Figure& figure : figures(shot)) {
            const std::string value = figure.beyond ? painted(figure.value, kRed) : figure.value;
            line(fmt::format("    {:<19} {}{}", figure.name, value,
                             figure.limit.empty() ? "" : painted("  limit " + figure.limit, kGrey)));
        }
        map(shot);
        pair("golden variant", shot.goldenVariant);
        pair("drawn by", shot.driver);
        pair(titlesOf(shot).expected, fromHere(shot.expected));
        pair(titlesOf(shot).got, fromHere(shot.got));
        pair("difference", fromHere(shot.difference));
        pair("reproduce", shot.reproduce);
        pair("accept", shot.accept);
        pair("would pass", shot.toPass);
        pair("no tolerance", shot.noTolerance.empty() ? "" : "is sensible: " + shot.noTolerance);
        line("");
    }
    /// The path as it opens from the current folder. Pictures of the run are named from the results folder.
    [[nodiscard]] std::string fromHere(const std::filesystem::path& picture) const {
        std::error_code failure;
        const std::filesystem::path inside = options_.resultsFolder / picture;
        const bool isInside = !picture.empty() && std::filesystem::exists(inside, failure);
        return (isInside ? inside : picture).generic_string();
    }
    void pair(std::string_view title, std::string_view value) {
        if (!value.empty()) line(fmt::format("    {:<15} {}", title, base::printableText(value)));
    }
    void map(const ShotResult& shot) {
        if (options_.mapColumns < 1 || shot.difference.empty()) return;
        const Result<std::vector<std::byte>> bytes =
            readNamed(shot.difference, options_.resultsFolder, base::Roots());
        if (!bytes) return;  // its path is printed below
        const Result<image::Image> picture =
            image::decodeImage(*bytes, options_.resultsFolder / shot.difference);
        if (!picture) return;
        for (const std::string& row : smallHeatMap(*picture, options_.mapColumns, options_.color))
            line(options_.color ? "    " + row : "    |" + row + "|");
    }

    const TextOptions& options_;
    std::string all_;
};

}  // namespace

std::string toText(const RunResult& run, const TextOptions& options) {
    Text text(options);
    int failures = 0, changed = 0;
    // Failures are last, next to the summary.
    for (const bool failing : {false, true})
        for (const ShotResult& shot : run.shots) {
            if (isFailure(shot.verdict) != failing || shot.verdict == Verdict::skipped) continue;
            if (shot.verdict == Verdict::passed && !shot.changed) continue;
            if (shot.verdict == Verdict::updated) continue;  // in the table
            changed += shot.verdict == Verdict::passed ? 1 : 0;
            failures += failing ? 1 : 0;
            text.shot(shot, failing && failures <= options.mostDetails);
        }
    text.updates(run);
    text.warnings(run);
    if (failures > options.mostDetails)
        text.line(fmt::format("the first {} failures are shown in full, {} more with one line each",
                              options.mostDetails, failures - options.mostDetails));
    if (const std::string missing = shortfall(run); !missing.empty())
        text.line(text.painted("incomplete: " + base::printableText(missing), kRed));
    std::string summary = counts(run);
    if (changed > 0)
        summary +=
            fmt::format(" ({} differ in bits from an earlier run on this driver and processor)", changed);
    summary += fmt::format("; {} in {}", base::counted(run.shots.size(), "shot"), readableTime(run.seconds));
    if (!run.driver.empty()) summary += ", " + base::printableText(run.driver);
    if (!run.shard.empty()) summary += ", shard " + base::printableText(run.shard);
    text.line(text.painted(summary, failures > 0 || !shortfall(run).empty() ? kRed : kGreen));
    return text.take();
}

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

/// Why a shot needs a look, how many of its pixels differ by how much, and what would pass it.
std::string why(const ShotResult& shot) {
    std::string text = cell(reasonOf(shot));
    if (const std::string steps = stepsText(shot); !steps.empty())
        text += "<br>pixels that differ by more than " + cell(steps);
    if (!shot.toPass.empty()) text += "<br>would pass: <code>" + cell(shot.toPass) + "</code>";
    if (!shot.noTolerance.empty()) text += "<br>no tolerance is sensible: " + cell(shot.noTolerance);
    return text;
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
    const std::string target = fmt::format("\"{}/{}\"", at, address(file.generic_string()));
    return file.extension() == ".png"  // browsers show no other that is written
               ? fmt::format("<img src={} width=\"160\">", target)
               : fmt::format("<a href={}>{}</a>", target, cell(file.filename().generic_string()));
}

}  // namespace

std::string toMarkdown(const RunResult& run, const MarkdownOptions& options) {
    std::string text = fmt::format("### Pictures: {}\n\n", cell(counts(run)));
    if (const std::string missing = shortfall(run); !missing.empty())
        text += fmt::format("**Incomplete:** {}\n\n", cell(missing));
    if (const std::string awaited = awaitedLine(run); !awaited.empty()) text += cell(awaited) + "\n\n";
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
                            isChangedPass(shot) ? "changed" : name(shot.verdict), why(shot));
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

namespace {

/// JUnit tells what could not be tried (an error) from what was tried and is wrong (a failure).
bool isError(const ShotResult& shot) {
    return isFailure(shot.verdict) && wasNotDrawn(shot);
}

bool isSkipped(Verdict verdict) {
    return verdict == Verdict::skipped || verdict == Verdict::quarantined;
}

struct Sums {
    int tests = 0, failures = 0, errors = 0, skipped = 0;
    double seconds = 0;
};

std::string seconds(double value) {
    constexpr double kMost = 1e12;  // more is no time, and would print hundreds of digits
    return fmt::format("{:.3f}", value >= 0 && value < kMost ? value : 0.);
}

Sums sumsOf(const std::vector<const ShotResult*>& shots) {
    Sums sums;
    for (const ShotResult* shot : shots) {
        ++sums.tests;
        if (isError(*shot))
            ++sums.errors;
        else if (isFailure(shot->verdict))
            ++sums.failures;
        else if (isSkipped(shot->verdict))
            ++sums.skipped;
        if (std::isfinite(shot->milliseconds)) sums.seconds += shot->milliseconds / 1000;
    }
    return sums;
}

std::string details(const ShotResult& shot) {
    std::string text = reasonOf(shot) + '\n';
    for (const Figure& figure : figures(shot))
        text += fmt::format("{}: {}{}\n", figure.name, figure.value,
                            figure.limit.empty() ? "" : fmt::format(", limit {}", figure.limit));
    const auto add = [&](std::string_view title, const std::string& value) {
        if (!value.empty()) text += fmt::format("{}: {}\n", title, value);
    };
    add("script", shot.script.generic_string());
    add("golden variant", shot.goldenVariant);
    add("drawn by", shot.driver);
    add(titlesOf(shot).got, shot.got.generic_string());
    add(titlesOf(shot).expected, shot.expected.generic_string());
    add("difference", shot.difference.generic_string());
    add("reproduce", shot.reproduce);
    add("accept", shot.accept);
    add("would pass", shot.toPass);
    add("no tolerance is sensible", shot.noTolerance);
    return text;
}

base::Fields fieldsOf(const ShotResult& shot) {
    const bool isWrong = isFailure(shot.verdict) && !isSkipped(shot.verdict);
    std::string output;
    if (!isFailure(shot.verdict) && !isSkipped(shot.verdict) && !reasonOf(shot).empty())
        output += reasonOf(shot) + '\n';
    for (const Diagnostic& each : shot.diagnostics) output += toString(each) + '\n';
    return {{"shot", shot.shot},
            {"seconds", seconds(shot.milliseconds / 1000)},
            {"isEmpty", !isWrong && !isSkipped(shot.verdict) && output.empty()},
            {"isSkipped", isSkipped(shot.verdict)},
            {"element", !isWrong        ? ""
                        : isError(shot) ? "error"
                                        : "failure"},
            {"reason", reasonOf(shot)},
            {"verdict", name(shot.verdict)},
            {"details", isWrong ? details(shot) : ""},
            {"output", output}};
}

base::Fields fieldsOf(const Sums& sums) {
    return {{"tests", sums.tests},
            {"failures", sums.failures},
            {"errors", sums.errors},
            {"skipped", sums.skipped},
            {"seconds", seconds(sums.seconds)}};
}

/// A suite with one test about the whole run: an error, a failure, or only an output. Adds it to the sums.
base::Fields ofRun(const char* test, std::string_view element, const char* type, const std::string& text,
                   Sums& all) {
    const int failures = element == "failure" ? 1 : 0, errors = element == "error" ? 1 : 0;
    ++all.tests;
    all.failures += failures;
    all.errors += errors;
    return {{"test", test},         {"element", element},
            {"text", text},         {"type", element == "system-out" ? "" : type},
            {"failures", failures}, {"errors", errors}};
}

}  // namespace

std::string toJunit(const RunResult& run) {
    std::vector<std::pair<std::string_view, std::vector<const ShotResult*>>> suites;
    for (const ShotResult& shot : run.shots) {
        auto suite = std::ranges::find_if(suites, [&](const auto& each) { return each.first == shot.suite; });
        if (suite == suites.end()) suite = suites.insert(suite, {shot.suite, {}});
        suite->second.push_back(&shot);
    }
    Sums all;
    std::vector<base::Fields> rows, rowsOfRun;
    for (const auto& [suite, shots] : suites) {
        const Sums sums = sumsOf(shots);
        all.tests += sums.tests;
        all.failures += sums.failures;
        all.errors += sums.errors;
        rows.push_back(fieldsOf(sums));
        base::append(rows.back(),
                     {{"name", suite},
                      {"shots", base::rowsOf(shots, [](const auto* each) { return fieldsOf(*each); })}});
    }
    if (const std::string missing = shortfall(run); !missing.empty())
        rowsOfRun.push_back(ofRun("every planned shot has a verdict", "error", "incomplete", missing, all));
    constexpr std::size_t kMostOrphans = 100;
    if (!run.orphans.empty())
        rowsOfRun.push_back(ofRun("every golden belongs to a shot",
                                  run.orphansFail ? "failure" : "system-out", "orphans",
                                  fmt::format("{}", fmt::join(orphanLines(run, kMostOrphans), "\n")), all));
    all.seconds = run.seconds;
    base::Fields fields = fieldsOf(all);
    base::append(fields, {{"began", run.began},
                          {"properties", base::titledRows({{"driver", run.driver},
                                                           {"machine", run.machine},
                                                           {"shard", run.shard},
                                                           {"command", run.command}})},
                          {"suites", std::move(rows)},
                          {"ofRun", std::move(rowsOfRun)}});
    return base::filled(report_page::junit_xml(), fields);
}

std::string reproduceCommand(const Shot& shot) {
    std::string command = "glibra render " + shellWord(shot.script.generic_string()) + optionArguments(shot);
    if (shot.expectedError) return command;
    std::string file = shot.name;
    std::ranges::replace(file, '/', '_');
    return command + " -o " + shellWord(file + (shot.options.floatPixels ? ".exr" : ".png"));
}

std::string checkCommand(const Shot& shot) {
    const auto isUnknown = [&](const OptionRow& row) {
        return std::ranges::find(kCheckOptions, row.name) == kCheckOptions.end() &&
               !optionWords(row, shot).empty();
    };
    if (std::ranges::any_of(optionTable(), isUnknown)) return {};
    return "glibra check --run " + shellWord(shot.script.generic_string()) + optionArguments(shot);
}

std::string renameCommand(const Suite& suite, const Shot& shot) {
    return fmt::format("glibra test {} --only {} --rename", shellWord(suite.file.generic_string()),
                       shellWord(shot.name));
}

std::string acceptCommand(const Suite& suite, const Shot& shot) {
    return fmt::format("glibra test {} --only {} --update", shellWord(suite.file.generic_string()),
                       shellWord(shot.name));
}

}  // namespace glibra::suite
