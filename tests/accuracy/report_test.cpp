// Reports as CSV, JSON and HTML, and the comparison of runs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "bench/core/run.h"
#include "bench/report/reports.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The cells of one RFC 4180 record.
std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells(1);
    bool isQuoted = false;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (line[i] == '"' && isQuoted && i + 1 < line.size() && line[i + 1] == '"')
            cells.back() += line[++i];
        else if (line[i] == '"')
            isQuoted = !isQuoted;
        else if (line[i] == ',' && !isQuoted)
            cells.emplace_back();
        else
            cells.back() += line[i];
    return cells;
}

TEST(Csv, HasOneRowPerPointWithFourteenCells) {
    const std::vector<std::string> lines = linesOf(csvReport(sampleReport()));
    ASSERT_EQ(lines.size(), 6U);
    for (const std::string& line : lines) EXPECT_EQ(cellsOf(line).size(), 14U) << line;
    const std::vector<std::string> first = cellsOf(lines[1]);
    EXPECT_EQ(first, (std::vector<std::string>{"primitives", "position", "float, \"textbook\" <1>", "8", "8",
                                               "0.1", "radii", "0.001", "0.0009000000000000001", "0.0011",
                                               "7", "4096", "0", ""}));
    EXPECT_EQ(cellsOf(lines[4])[5], "") << "not measurable";
    EXPECT_EQ(cellsOf(lines[5])[5], "inf");
}

TEST(Html, DrawsATheoryInTheColourOfItsMeasuredCurve) {
    Report report;
    Figure figure;
    figure.name = "gap";
    figure.curves = {{"a", {pointAt(1, .2), pointAt(2, .1)}},
                     {"b", {pointAt(1, .3), pointAt(2, .2)}},
                     {"theory: b", {pointAt(1, .3), pointAt(2, .2)}, 1}};
    report.subjects.emplace_back();
    report.subjects[0].name = "depth";
    report.subjects[0].figures = {figure};
    const std::string page = htmlReport(report, nullptr);
    EXPECT_NE(page.find("curve c1\" data-curve=\"2\"><path class=\"line theory\""), std::string::npos);
    EXPECT_EQ(page.find("curve c2"), std::string::npos);
    const Result<Report> read = readJsonReport(jsonReport(report), "a.json");
    ASSERT_TRUE(read) << toString(read.diagnostics.front());
    EXPECT_EQ(read->subjects[0].figures[0].curves[2].theoryOf, 1U);
    EXPECT_FALSE(read->subjects[0].figures[0].curves[1].theoryOf);
}

TEST(Json, SurvivesARoundTrip) {
    const Report report = sampleReport();
    const std::string text = jsonReport(report);
    const Result<Report> read = readJsonReport(text, "a.json");
    ASSERT_TRUE(read) << toString(read.diagnostics.front());
    EXPECT_EQ(jsonReport(*read), text);
    const Figure &before = report.subjects[0].figures[0], &after = read->subjects[0].figures[0];
    EXPECT_EQ(after.alternatives, Alternatives::curve);
    EXPECT_EQ(after.curves[0].points[1].error, before.curves[0].points[1].error);
    EXPECT_EQ(after.curves[0].points[0].time->high, before.curves[0].points[0].time->high);
    EXPECT_EQ(after.curves[0].points[0].memory, 4096);
    EXPECT_FALSE(after.curves[1].points[0].time);
    EXPECT_TRUE(std::isnan(after.curves[1].points[1].error));
    EXPECT_TRUE(std::isinf(after.curves[1].points[2].error));
    EXPECT_EQ(read->subjects[0].diagnostics[0].id, "gpu-E01");
    EXPECT_EQ(read->machine.processor, "Processor <A> & B");
}

TEST(Json, KeepsEveryDigitAndWhatIsNotMeasured) {
    Report report = sampleReport();
    std::vector<Point>& points = report.subjects[0].figures[0].curves[0].points;
    points = {{.setting = 3, .label = "a \"quoted\" label", .error = 1. / 3},
              {.setting = 4, .label = "", .error = std::numeric_limits<double>::quiet_NaN()}};
    points[0].time = Timing{.median = 1e-7, .low = 1e-8, .high = 1. / 7, .repeats = 11};
    points[1].memory = 1e9;
    const Result<Report> read = readJsonReport(jsonReport(report), "bench.json");
    ASSERT_TRUE(read);
    const std::vector<Point>& back = read->subjects[0].figures[0].curves[0].points;
    ASSERT_EQ(back.size(), 2U);
    EXPECT_EQ(back[0].error, 1. / 3);
    EXPECT_EQ(back[0].label, points[0].label);
    ASSERT_TRUE(back[0].time);
    EXPECT_EQ(back[0].time->high, 1. / 7);
    EXPECT_EQ(back[0].time->repeats, 11);
    EXPECT_FALSE(back[0].memory);
    EXPECT_TRUE(std::isnan(back[1].error));
    EXPECT_EQ(back[1].memory, 1e9);
}

TEST(Json, ReportsThePlaceOfAnError) {
    const Result<Report> broken = readJsonReport("{\n \"format\": ]\n}", "b.json");
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.diagnostics[0].id, "bench-E02");
    EXPECT_EQ(broken.diagnostics[0].place, (Place{"b.json", 2, 12}));
    for (const char* other : {"{}", "[1, 2]", "3", "{\"format\": \"other\"}", ""})
        EXPECT_FALSE(readJsonReport(other, "c.json")) << other;
    std::string wrong = jsonReport(sampleReport());
    wrong.replace(wrong.find("\"cores\": 4"), 10, "\"cores\": {}");
    EXPECT_FALSE(readJsonReport(wrong, "d.json"));
}

TEST(Json, EveryCutIsRejected) {
    const std::string text = jsonReport(sampleReport());
    for (std::size_t length = 0; length + 2 < text.size(); length += 7)
        EXPECT_FALSE(readJsonReport(std::string_view(text).substr(0, length), "cut.json")) << length;
}

TEST(Against, TheSameRunReportsNothing) {
    const RunComparison same = compare(sampleReport(), sampleReport());
    EXPECT_EQ(same.points.size(), 5U);
    EXPECT_FALSE(isWorse(same));
    EXPECT_TRUE(same.sameMachine);
    EXPECT_TRUE(same.missing.empty());
    EXPECT_EQ(linesOf(comparisonText(same)).size(), 1U) << comparisonText(same);
    EXPECT_EQ(*same.points[0].timeRatio, 1);
}

TEST(Against, AGrownErrorIsWorseBeyondTheTolerance) {
    Report now = sampleReport();
    double& error = now.subjects[0].figures[0].curves[0].points[1].error;
    error *= 1.04;
    EXPECT_FALSE(isWorse(compare(sampleReport(), now)));
    error *= 1.04;
    const RunComparison worse = compare(sampleReport(), now);
    EXPECT_TRUE(isWorse(worse));
    EXPECT_NE(
        comparisonText(worse).find("worse   primitives/position, float, \"textbook\" <1>, 16: error 0.025"),
        std::string::npos)
        << comparisonText(worse);
    EXPECT_FALSE(isWorse(compare(sampleReport(), now, {.errorTolerance = .1})));
    EXPECT_FALSE(isWorse(compare(now, sampleReport()))) << "the other way it got better";
}

TEST(Against, AnErrorThatIsNotMeasurableAnyMoreOrLeavesZeroIsWorse) {
    Report now = sampleReport();
    now.subjects[0].figures[0].curves[0].points[0].error = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(isWorse(compare(sampleReport(), now)));
    now = sampleReport();
    now.subjects[0].figures[0].curves[1].points[0].error = 1e-9;
    EXPECT_TRUE(isWorse(compare(sampleReport(), now)));
}

TEST(Against, TimesCountOnlyWithAFactorAndBeyondTheSpread) {
    Report now = sampleReport();
    Timing& time = *now.subjects[0].figures[0].curves[0].points[0].time;
    time = {1.15e-3, 1.05e-3, 1.2e-3, 7};  // overlaps the earlier .9e-3 .. 1.1e-3
    EXPECT_FALSE(compare(sampleReport(), now).points[0].timeIsWorse);
    time = {3e-3, 2.9e-3, 3.1e-3, 7};
    EXPECT_TRUE(compare(sampleReport(), now).points[0].timeIsWorse);
    EXPECT_FALSE(isWorse(compare(sampleReport(), now)));
    EXPECT_TRUE(isWorse(compare(sampleReport(), now, {.timeFactor = 2})));
    EXPECT_FALSE(isWorse(compare(sampleReport(), now, {.timeFactor = 4})));
}

TEST(Against, NamesMissingPointsAndOtherMachines) {
    Report now = sampleReport();
    now.subjects[0].figures[0].curves[1].points.pop_back();
    now.machine.renderer = "other";
    const RunComparison comparison = compare(sampleReport(), now);
    EXPECT_EQ(comparison.missing, (std::vector<std::string>{"primitives/position/double 32"}));
    EXPECT_FALSE(comparison.sameMachine);
    now.quick = false;
    EXPECT_TRUE(compare(sampleReport(), now).missing.empty()) << "a quick run has fewer settings";
}

/// Every element is closed in the right order, and the page loads nothing.
std::string firstImbalance(const std::string& page) {
    std::vector<std::string> open;
    for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at)) {
        const std::size_t end = page.find('>', at);
        if (end == std::string::npos) return "a tag without end";
        const std::string tag = page.substr(at + 1, end - at - 1);
        at = end + 1;
        const std::string name = tag.substr(0, tag.find_first_of(" \n/", 1));
        if (tag[0] == '!' || name == "meta" || name == "link" || tag.back() == '/') continue;
        if (tag[0] == '/') {
            if (open.empty() || "/" + open.back() != tag) return tag + " closes nothing";
            open.pop_back();
            continue;
        }
        open.push_back(name);
        if (name == "script" || name == "style") at = page.find("</" + name, at);
    }
    return open.empty() ? "" : open.back() + " stays open";
}

TEST(Html, IsWellFormedAndNeedsNothingElse) {
    const Report report = sampleReport();
    const RunComparison comparison = compare(report, report);
    const std::string page = htmlReport(report, &comparison);
    EXPECT_EQ(firstImbalance(page), "");
    for (const char* outside : {"http:", "https:", "src=", "@import", "url("})
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    EXPECT_EQ(page.find("{{"), std::string::npos) << "a slot without content";
    EXPECT_EQ(page.find("<1>"), std::string::npos) << "names are escaped";
    EXPECT_NE(page.find("Processor &lt;A&gt; &amp; B"), std::string::npos);
    EXPECT_NE(page.find("slices<sup>-2.00</sup>"), std::string::npos);
    EXPECT_NE(page.find("nothing is worse"), std::string::npos);
    EXPECT_NE(page.find("no usable OpenGL driver"), std::string::npos);
}

TEST(Html, ShowsEachMeasurablePointInItsDiagrams) {
    const std::string page = htmlReport(sampleReport());
    const auto count = [&](std::string_view what) {
        std::size_t found = 0;
        for (std::size_t at = page.find(what); at != std::string::npos; at = page.find(what, at + 1)) ++found;
        return found;
    };
    // Against the setting: both timed points and the one with error 0. Against time: the timed points.
    EXPECT_EQ(count("data-tip="), 5U);
    EXPECT_EQ(count("class=\"spread\""), 2U);
    EXPECT_EQ(count("<svg class=\"plot\""), 2U);
    EXPECT_EQ(count("<tr><th scope=\"row\">"), 5U);
}

TEST(Text, NamesCurvesFindingsAndTheMachine) {
    const Report report = sampleReport();
    const std::string text = textReport(report.subjects[0]);
    EXPECT_NE(text.find("8: 0.1 radii in 1 ms; 16: 0.025 radii in 4 ms"), std::string::npos) << text;
    EXPECT_NE(text.find("    - error falls as slices^-2.00\n"), std::string::npos);
    EXPECT_EQ(machineLine(report.machine), "Processor <A> & B, 4 cores, Linux 1 x; llvmpipe");
}

}  // namespace
}  // namespace glibra::bench::test
