#include "suite/report/html_report.h"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "base/lines.h"
#include "base/page_template.h"
#include "base/text.h"
#include "embedded/report_page.h"
#include "image/file.h"
#include "suite/report/report_files.h"
#include "suite/results/figures.h"

namespace glibra::suite {
namespace {

base::Fields fieldsOf(const Diagnostic& remark) {
    return {{"severity", name(remark.severity)}, {"text", toString(remark)}};
}

/// The lines of a file, each with its diagnostics.
base::Fields fieldsOf(const Source& source, const Diagnostics& diagnostics) {
    std::vector<base::Fields> lines;
    for (std::string_view rest = source.text; !rest.empty();) {
        const int line = static_cast<int>(lines.size()) + 1;
        std::vector<base::Fields> remarks;
        for (const Diagnostic& each : diagnostics)
            if (each.place.file == source.file && each.place.line == line) remarks.push_back(fieldsOf(each));
        lines.push_back({{"line", line}, {"text", base::nextLine(rest)}, {"remarks", std::move(remarks)}});
    }
    return {{"file", source.file}, {"lines", std::move(lines)}};
}

std::string labelOf(const ShotResult& shot) {
    return shot.suite + "/" + shot.shot;
}

base::Fields fieldsOf(const ShotResult& shot, const ShownShot& shown, std::span<const Source> sources) {
    std::vector<base::Fields> pictures;
    if (!shown.expected.empty() || !shown.got.empty())
        pictures = {{{"title", titlesOf(shot).expected}, {"file", shown.expected}},
                    {{"title", titlesOf(shot).got}, {"file", shown.got}},
                    {{"title", "difference"}, {"file", shown.difference}}};
    const auto figure = [](const Figure& each) {
        return base::Fields{
            {"name", each.name}, {"value", each.value}, {"limit", each.limit}, {"beyond", each.beyond}};
    };
    const auto listing = [&](std::size_t source) { return fieldsOf(sources[source], shot.diagnostics); };
    return {
        {"verdict", name(shot.verdict)},
        {"label", labelOf(shot)},
        {"reason", reasonOf(shot)},
        {"pictures", std::move(pictures)},
        {"figures", base::rowsOf(figures(shot), figure)},
        {"commands", base::titledRows({{"Reproduce", shot.reproduce},
                                       {"Accept", shot.accept},
                                       {"Would pass, in the [[shot]] of the suite", shot.toPass},
                                       {"No tolerance is sensible", shot.noTolerance}})},
        {"remarks", base::rowsOf(shot.diagnostics, [](const Diagnostic& each) { return fieldsOf(each); })},
        {"sources", base::rowsOf(shown.sources, listing)}};
}

}  // namespace

std::string plainPage(const RunResult& run, std::span<const ShownShot> shown,
                      std::span<const Source> sources) {
    std::vector<base::Fields> articles, lists;
    for (const Verdict verdict : kVerdictsByConcern)
        for (std::size_t i = 0; i < run.shots.size(); ++i)
            if (run.shots[i].verdict == verdict && !isPlain(run.shots[i]))
                articles.push_back(fieldsOf(run.shots[i], shown[i], sources));
    for (const Verdict verdict : {Verdict::skipped, Verdict::passed}) {
        std::vector<base::Fields> shots;
        for (std::size_t i = 0; i < run.shots.size(); ++i)
            if (run.shots[i].verdict == verdict && isPlain(run.shots[i]))
                shots.push_back({{"label", labelOf(run.shots[i])}, {"file", shown[i].got}});
        if (!shots.empty())
            lists.push_back({{"count", shots.size()}, {"verdict", name(verdict)}, {"shots", shots}});
    }
    return loadingFirstScreen(base::filled(
        report_page::plain_html(), {{"counts", counts(run)}, {"articles", articles}, {"lists", lists}}));
}

std::string loadingFirstScreen(std::string html) {
    constexpr std::string_view kLazy = " loading=\"lazy\"";
    constexpr int kFirst = 24;
    std::size_t at = 0;
    for (int i = 0; i < kFirst && (at = html.find(kLazy, at)) != std::string::npos; ++i)
        html.erase(at, kLazy.size());
    return html;
}

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
    add("script", shot.script.generic_string());
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
    add("toPass", shot.toPass);
    add("noTolerance", shot.noTolerance);
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
    if (!run.missingShards.empty()) text += ", " + run.missingShards;
    if (!run.orphans.empty())
        text += fmt::format(", {} of no shot", base::counted(run.orphans.size(), "golden"));
    return text;
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
    constexpr std::size_t kMostOrphans = 100;
    const base::Fields fields = {
        {"title", counts(run) + " - glibra"},
        {"headline", headline(run)},
        {"run", fmt::format("About this run ({})", readableTime(run.seconds))},
        {"details", base::titledRows({{"Driver", run.driver},
                                      {"Machine", run.machine},
                                      {"Command", run.command},
                                      {"Shard", run.shard},
                                      {"Began", run.began},
                                      {"Time", readableTime(run.seconds)}})},
        {"orphans", orphanLines(run, kMostOrphans)},  // no shot of the list speaks of them
        {"style", report_page::report_css()},
        {"script", std::move(script)},
        {"static", plainPage(run, shown, files.sources())},
        {"data", toJson(run, shown, files)},
    };
    const std::string page = base::filled(report_page::page_html(), fields);
    Diagnostics problems = files.problems();
    static_cast<void>(base::prepareBeneath(reportFolder, "index.html"));  // the write below reports a failure
    append(problems, image::writeFileAtomically(reportFolder / "index.html", std::as_bytes(std::span(page)),
                                                image::NamedBy::program));
    if (!hasError(problems)) files.removeOthers();
    return problems;
}

}  // namespace glibra::suite
