#include "suite/report/html_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "base/page_template.h"
#include "base/text.h"
#include "embedded/report_page.h"
#include "image/file.h"
#include "suite/report/plain_page.h"
#include "suite/report/report_files.h"
#include "suite/results/figures.h"

namespace glibra::suite {
namespace {

/// JSON for a <script> element. Without '<' nothing in it can close or open an element.
std::string inScript(const nlohmann::ordered_json& json) {
    std::string text;
    for (const char each : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
        if (each == '<')
            text += "\\u003c";
        else
            text += each;
    return text;
}

nlohmann::ordered_json toJson(const ShotResult& shot, const ShownShot& shown) {
    nlohmann::ordered_json json = {
        {"suite", shot.suite}, {"shot", shot.shot}, {"verdict", name(shot.verdict)}};
    const auto add = [&](const char* key, const auto& value) {
        if (!value.empty()) json[key] = value;
    };
    add("reason", reasonOf(shot));
    add("script", shot.script.string());
    add("expected", shown.expected);
    add("got", shown.got);
    add("difference", shown.difference);
    add("pixels", shown.pixels);
    if (const PictureTitles titles = titlesOf(shot); std::string_view(titles.expected) != "expected")
        json["titles"] = {{"expected", titles.expected}, {"got", titles.got}};
    add("variant", shot.goldenVariant);
    add("driver", shot.driver);
    add("decision", decision(shot));
    add("reproduce", shot.reproduce);
    add("accept", shot.accept);
    add("sources", shown.sources);
    add("remarks", shown.remarks);
    if (shot.changed) json["changed"] = true;
    if (shot.width > 0) {
        json["width"] = shot.width;
        json["height"] = shot.height;
    }
    if (shot.milliseconds > 0) json["milliseconds"] = shot.milliseconds;
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Figure& each : figures(shot)) list.push_back({each.name, each.value, each.limit, each.beyond});
    add("figures", list);
    nlohmann::ordered_json told = nlohmann::ordered_json::array();
    for (const Diagnostic& each : shot.diagnostics)
        if (!isPlain(shot) || each.severity == Severity::warning)
            told.push_back({name(each.severity), each.id, each.text, each.place.file, each.place.line,
                            each.place.column});
    add("diagnostics", told);
    return json;
}

std::string toJson(const RunResult& run, std::span<const ShownShot> shown, const ReportFiles& files) {
    nlohmann::ordered_json json = {{"run", {{"driver", run.driver}}}};
    for (const Verdict verdict : kVerdictsByConcern) json["groups"].push_back(name(verdict));
    json["sources"] = nlohmann::ordered_json::array();
    for (const Source& source : files.sources())
        json["sources"].push_back({{"file", source.file}, {"text", source.text}});
    json["shots"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < run.shots.size(); ++i)
        json["shots"].push_back(toJson(run.shots[i], shown[i]));
    return inScript(json);
}

std::string headline(const RunResult& run) {
    const auto count = [&](const auto& fits) { return std::ranges::count_if(run.shots, fits); };
    const auto drawn = count([](const ShotResult& shot) { return shot.verdict == Verdict::missing; });
    const auto failures = count([](const ShotResult& shot) { return isFailure(shot.verdict); }) - drawn;
    std::string text = fmt::format("{} of {} shots failed", failures, run.shots.size());
    if (failures == 0 && drawn == 0)
        text = run.shots.empty() ? "No shots" : fmt::format("None of {} shots failed", run.shots.size());
    if (drawn > 0) text += fmt::format(", {} drawn without a golden", drawn);
    if (const std::size_t missing = missingShots(run).size(); missing > 0)
        text += fmt::format(", {} of {} planned shots have no verdict", missing, plannedCount(run));
    if (!run.missingShards.empty()) text += ", " + base::escapeXml(run.missingShards);
    if (!run.orphans.empty())
        text += fmt::format(", {} of no shot", base::counted(run.orphans.size(), "golden"));
    return text;
}

/// The goldens of no shot, of which no shot of the list speaks.
std::string orphanList(const RunResult& run) {
    constexpr std::size_t kMost = 100;
    std::string html;
    for (const std::string& line : orphanLines(run, kMost))
        html += fmt::format("<p class=\"orphans\">{}</p>", base::escapeXml(line));
    return html;
}

std::string runDetails(const RunResult& run) {
    std::string html = "<dl>";
    const auto add = [&](std::string_view title, const std::string& value) {
        if (!value.empty()) html += fmt::format("<dt>{}</dt><dd>{}</dd>", title, base::escapeXml(value));
    };
    add("Driver", run.driver);
    add("Machine", run.machine);
    add("Command", run.command);
    add("Shard", run.shard);
    add("Began", run.began);
    add("Time", readableTime(run.seconds));
    return html + "</dl>";
}

}  // namespace

Diagnostics writeHtmlReport(const RunResult& run, const std::filesystem::path& resultsFolder,
                            const std::filesystem::path& reportFolder, const ReportRoots& roots) {
    ReportFiles files(resultsFolder, reportFolder, roots);
    std::vector<ShownShot> shown;
    shown.reserve(run.shots.size());
    for (const ShotResult& shot : run.shots) shown.push_back(files.add(shot, shown.size() + 1));
    if (hasError(files.problems())) return files.problems();

    std::string script;
    for (const std::string_view part :
         {report_page::pixels_js(), report_page::viewer_js(), report_page::list_js(), report_page::main_js()})
        script += part;
    const base::Slot slots[] = {
        {"title", base::escapeXml(counts(run) + " - glibra")},
        {"headline", headline(run)},
        {"run", fmt::format("About this run ({})", readableTime(run.seconds))},
        {"runDetails", runDetails(run)},
        {"orphans", orphanList(run)},
        {"style", std::string(report_page::report_css())},
        {"script", std::move(script)},
        {"static", plainPage(run, shown, files.sources())},
        {"data", toJson(run, shown, files)},
    };
    const std::string page = base::filled(report_page::page_html(), slots);
    Diagnostics problems = files.problems();
    static_cast<void>(base::prepareBeneath(reportFolder, "index.html"));  // the write below reports a failure
    append(problems, image::writeFileAtomically(reportFolder / "index.html", std::as_bytes(std::span(page)),
                                                image::NamedBy::program));
    if (!hasError(problems)) files.removeOthers();
    return problems;
}

}  // namespace glibra::suite
