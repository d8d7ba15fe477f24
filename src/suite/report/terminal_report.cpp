#include "suite/report/terminal_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/text.h"
#include "base/utf8.h"
#include "image/read.h"
#include "suite/report/small_heat_map.h"
#include "suite/results/figures.h"
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
        line("");
    }
    /// The path as it opens from the current folder. Pictures of the run are named from the results folder.
    [[nodiscard]] std::string fromHere(const std::filesystem::path& picture) const {
        std::error_code failure;
        const std::filesystem::path inside = options_.resultsFolder / picture;
        const bool isInside = !picture.empty() && std::filesystem::exists(inside, failure);
        return (isInside ? inside : picture).string();
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
            changed += shot.verdict == Verdict::passed ? 1 : 0;
            failures += failing ? 1 : 0;
            text.shot(shot, failing && failures <= options.mostDetails);
        }
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

}  // namespace glibra::suite
