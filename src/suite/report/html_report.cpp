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
#include "suite/report/report_files.h"
#include "suite/results/figures.h"

namespace glibra::suite {
namespace {

std::string remarkLine(const Diagnostic& each) {
    return fmt::format("<li class=\"remark {}\">{}</li>", name(each.severity),
                       base::escapeXml(toString(each)));
}

std::string picture(std::string_view title, const std::string& file) {
    if (file.empty()) return fmt::format("<figure><figcaption>{}: no picture</figcaption></figure>", title);
    return fmt::format(
        "<figure><figcaption>{0}</figcaption><a href=\"{1}\"><img src=\"{1}\" alt=\"{0}\" "
        "loading=\"lazy\"></a></figure>",
        title, file);
}

/// The lines of a file, each with its diagnostics below it.
std::string listing(const Source& source, const Diagnostics& diagnostics) {
    std::string html =
        fmt::format("<details><summary>{}</summary><div class=\"source\"><ol>", base::escapeXml(source.file));
    std::string_view rest = source.text;
    for (int line = 1; !rest.empty(); ++line) {
        const std::size_t end = rest.find('\n');
        std::string remarks;
        for (const Diagnostic& each : diagnostics)
            if (each.place.file == source.file && each.place.line == line) remarks += remarkLine(each);
        html +=
            fmt::format("<li data-line=\"{}\"{}>{}</li>{}", line, remarks.empty() ? "" : " class=\"told\"",
                        base::escapeXml(rest.substr(0, end)), remarks);
        if (end == std::string_view::npos) break;
        rest.remove_prefix(end + 1);
    }
    return html + "</ol></div></details>";
}

std::string article(const ShotResult& shot, const ShownShot& shown, std::span<const Source> sources) {
    std::string html = fmt::format("<article><h2><span class=\"verdict {0}\">{0}</span> {1}</h2><p>{2}</p>",
                                   name(shot.verdict), base::escapeXml(shot.suite + "/" + shot.shot),
                                   base::escapeXml(reasonOf(shot)));
    if (!shown.expected.empty() || !shown.got.empty())
        html += "<div class=\"trio\">" + picture(titlesOf(shot).expected, shown.expected) +
                picture(titlesOf(shot).got, shown.got) + picture("difference", shown.difference) + "</div>";
    std::string rows;
    for (const Figure& each : figures(shot))
        rows += fmt::format("<tr><th>{}</th><td{}>{}</td><td>{}</td></tr>", each.name,
                            each.beyond ? " class=\"beyond\"" : "", each.value,
                            each.limit.empty() ? "" : "limit " + each.limit);
    if (!rows.empty()) html += "<table>" + rows + "</table>";
    for (const auto& [title, command] :
         {std::pair<const char*, const std::string&>{"Reproduce", shot.reproduce},
          {"Accept", shot.accept},
          {"Would pass, in the [[shot]] of the suite", shot.toPass},
          {"No tolerance is sensible", shot.noTolerance}})
        if (!command.empty())
            html += fmt::format("<h3>{}</h3><div class=\"command\"><code>{}</code></div>", title,
                                base::escapeXml(command));
    std::string told;
    for (const Diagnostic& each : shot.diagnostics) told += remarkLine(each);
    if (!told.empty()) html += "<ul>" + told + "</ul>";
    for (const std::size_t source : shown.sources) html += listing(sources[source], shot.diagnostics);
    return html + "</article>\n";
}

}  // namespace

std::string plainPage(const RunResult& run, std::span<const ShownShot> shown,
                      std::span<const Source> sources) {
    std::string html = fmt::format("<div class=\"plain\">\n<p>{}</p>\n", counts(run));
    for (const Verdict verdict : kVerdictsByConcern)
        for (std::size_t i = 0; i < run.shots.size(); ++i)
            if (run.shots[i].verdict == verdict && !isPlain(run.shots[i]))
                html += article(run.shots[i], shown[i], sources);
    for (const Verdict verdict : {Verdict::skipped, Verdict::passed}) {
        std::string names;
        int count = 0;
        for (std::size_t i = 0; i < run.shots.size(); ++i) {
            const ShotResult& shot = run.shots[i];
            if (shot.verdict != verdict || !isPlain(shot)) continue;
            ++count;
            const std::string label = base::escapeXml(shot.suite + "/" + shot.shot);
            names += shown[i].got.empty()
                         ? fmt::format("<li>{}</li>\n", label)
                         : fmt::format("<li><a href=\"{}\">{}</a></li>\n", shown[i].got, label);
        }
        if (count > 0)
            html += fmt::format("<details><summary>{} {}</summary><ul>\n{}</ul></details>\n", count,
                                name(verdict), names);
    }
    return loadingFirstScreen(html + "</div>");
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
