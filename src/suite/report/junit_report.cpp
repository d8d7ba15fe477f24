#include "suite/report/junit_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/text.h"
#include "suite/results/figures.h"

namespace glibra::suite {
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
    add("script", shot.script.string());
    add("golden variant", shot.goldenVariant);
    add("drawn by", shot.driver);
    add(titlesOf(shot).got, shot.got.string());
    add(titlesOf(shot).expected, shot.expected.string());
    add("difference", shot.difference.string());
    add("reproduce", shot.reproduce);
    add("accept", shot.accept);
    return text;
}

void putShot(std::string& xml, const ShotResult& shot) {
    xml += fmt::format("    <testcase name=\"{}\" classname=\"{}\" time=\"{}\"", base::escapeXml(shot.shot),
                       base::escapeXml(shot.suite), seconds(shot.milliseconds / 1000));
    std::string inside;
    if (isSkipped(shot.verdict)) {
        inside += fmt::format("      <skipped message=\"{}\"/>\n", base::escapeXml(reasonOf(shot)));
    } else if (isFailure(shot.verdict)) {
        const char* element = isError(shot) ? "error" : "failure";
        inside +=
            fmt::format("      <{0} message=\"{1}\" type=\"{2}\">{3}</{0}>\n", element,
                        base::escapeXml(reasonOf(shot)), name(shot.verdict), base::escapeXml(details(shot)));
    }
    std::string output;
    if (!isFailure(shot.verdict) && !isSkipped(shot.verdict) && !reasonOf(shot).empty())
        output += reasonOf(shot) + '\n';
    for (const Diagnostic& each : shot.diagnostics) output += toString(each) + '\n';
    if (!output.empty())
        inside += fmt::format("      <system-out>{}</system-out>\n", base::escapeXml(output));
    xml += inside.empty() ? "/>\n" : ">\n" + inside + "    </testcase>\n";
}

/// A suite with one test about the whole run: an error, a failure, or only an output.
std::string ofRun(std::string_view test, std::string_view element, std::string_view type,
                  const std::string& text) {
    const std::string attributes =
        element == "system-out" ? ""
                                : fmt::format(" message=\"{}\" type=\"{}\"", base::escapeXml(text), type);
    return fmt::format(
        "  <testsuite name=\"glibra\" tests=\"1\" failures=\"{}\" errors=\"{}\" skipped=\"0\" "
        "time=\"0.000\">\n"
        "    <testcase name=\"{}\" classname=\"glibra\" time=\"0.000\">\n"
        "      <{}{}>{}</{}>\n    </testcase>\n  </testsuite>\n",
        element == "failure" ? 1 : 0, element == "error" ? 1 : 0, test, element, attributes,
        base::escapeXml(text), element);
}

}  // namespace

std::string toJunit(const RunResult& run) {
    std::vector<std::pair<std::string_view, std::vector<const ShotResult*>>> suites;
    for (const ShotResult& shot : run.shots) {
        auto suite = std::ranges::find_if(suites, [&](const auto& each) { return each.first == shot.suite; });
        if (suite == suites.end()) suite = suites.insert(suite, {shot.suite, {}});
        suite->second.push_back(&shot);
    }
    std::string inside;
    Sums all;
    for (const auto& [suite, shots] : suites) {
        const Sums sums = sumsOf(shots);
        all.tests += sums.tests;
        all.failures += sums.failures;
        all.errors += sums.errors;
        inside += fmt::format(
            "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{}\"",
            base::escapeXml(suite), sums.tests, sums.failures, sums.errors, sums.skipped,
            seconds(sums.seconds));
        if (!run.began.empty()) inside += fmt::format(" timestamp=\"{}\"", base::escapeXml(run.began));
        inside += ">\n    <properties>\n";
        for (const auto& [key, value] : {std::pair<const char*, const std::string&>{"driver", run.driver},
                                         {"machine", run.machine},
                                         {"shard", run.shard},
                                         {"command", run.command}})
            if (!value.empty())
                inside +=
                    fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", key, base::escapeXml(value));
        inside += "    </properties>\n";
        for (const ShotResult* shot : shots) putShot(inside, *shot);
        inside += "  </testsuite>\n";
    }
    if (const std::string missing = shortfall(run); !missing.empty()) {
        ++all.tests;
        ++all.errors;
        inside += ofRun("every planned shot has a verdict", "error", "incomplete", missing);
    }
    if (!run.orphans.empty()) {
        ++all.tests;
        all.failures += run.orphansFail ? 1 : 0;
        constexpr std::size_t kMost = 100;
        std::string text;
        for (const std::string& line : orphanLines(run, kMost)) text += (text.empty() ? "" : "\n") + line;
        inside += ofRun("every golden belongs to a shot", run.orphansFail ? "failure" : "system-out",
                        "orphans", text);
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<testsuites name=\"glibra\" tests=\"{}\" failures=\"{}\" errors=\"{}\" "
        "time=\"{}\">\n{}</testsuites>\n",
        all.tests, all.failures, all.errors, seconds(run.seconds), inside);
}

}  // namespace glibra::suite
