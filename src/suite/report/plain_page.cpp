#include "suite/report/plain_page.h"

#include <fmt/format.h>

#include <string_view>

#include "base/text.h"
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
         {std::pair<const char*, const std::string&>{"Reproduce", shot.reproduce}, {"Accept", shot.accept}})
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

}  // namespace glibra::suite
