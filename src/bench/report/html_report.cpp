#include "bench/report/html_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "base/page_template.h"
#include "base/text.h"
#include "bench/core/fit.h"
#include "bench/report/plot.h"
#include "embedded/bench_page.h"

namespace glibra::bench {
namespace {

std::string machineDetails(const Report& report) {
    const Machine& machine = report.machine;
    std::string html = "<dl class=\"machine\">";
    const auto add = [&](std::string_view title, const std::string& value) {
        if (!value.empty())
            html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", title, base::escapeXml(value));
    };
    add("Processor", machine.processor);
    if (machine.cores > 0) add("Cores", std::to_string(machine.cores));
    if (machine.memory > 0) add("Memory", bytesText(machine.memory));
    add("System", machine.system);
    add("Compiler", machine.compiler);
    add("OpenGL", machine.driver.empty() ? "no driver" : machine.renderer + ", " + machine.version);
    add("Opened by", machine.driver);
    add("glibra", report.glibra);
    add("Date", report.date);
    if (report.quick) add("Extent", "quick: fewer settings and measurements");
    return html + "</dl>\n";
}

/// Escapes the text and raises exponents such as "^-2.00".
std::string withPowers(std::string_view text) {
    const std::string escaped = base::escapeXml(text);
    std::string html;
    for (std::size_t i = 0; i < escaped.size(); ++i) {
        const std::size_t end =
            escaped[i] == '^' ? std::min(escaped.find_first_not_of("-.0123456789", i + 1), escaped.size())
                              : i;
        if (end > i + 1) {
            html += fmt::format("<sup>{}</sup>", escaped.substr(i + 1, end - i - 1));
            i = end - 1;
        } else {
            html += escaped[i];
        }
    }
    return html;
}

std::string list(const std::vector<std::string>& items, std::string_view style) {
    if (items.empty()) return {};
    std::string html = fmt::format("<ul class=\"{}\">", style);
    for (const std::string& each : items) html += fmt::format("<li>{}</li>", withPowers(each));
    return html + "</ul>\n";
}

std::string legend(const Figure& figure) {
    std::string html = "<ul class=\"legend\">";
    for (std::size_t i = 0; i < figure.curves.size(); ++i)
        html += fmt::format("<li data-curve=\"{}\">{}{}</li>", i, legendSign(figure, i),
                            base::escapeXml(figure.curves[i].name));
    return html + "</ul>\n";
}

/// A time for a table: the median; the tooltip shows the spread.
std::string timeCell(const Timing& time) {
    return fmt::format("<td title=\"{} to {}, {} measurements\">{}</td>", secondsText(time.low, true),
                       secondsText(time.high, true), time.repeats, secondsText(time.median, true));
}

std::string table(const Figure& figure) {
    std::size_t count = 0;
    bool hasTime = false, hasMemory = false, hasGpuTime = false;
    std::string rows;
    for (const Curve& curve : figure.curves)
        for (const Point& point : curve.points) {
            ++count;
            hasTime |= point.time.has_value();
            hasMemory |= point.memory.has_value();
            hasGpuTime |= point.gpuTime.has_value();
        }
    for (const Curve& curve : figure.curves)
        for (const Point& point : curve.points) {
            rows += fmt::format("<tr{}><th scope=\"row\">{}</th><td class=\"label\">{}</td><td>{}</td>",
                                point.isOnFront ? " class=\"on\"" : "", base::escapeXml(curve.name),
                                base::escapeXml(point.label), numberText(point.error));
            if (hasTime) rows += point.time ? timeCell(*point.time) : "<td></td>";
            if (hasGpuTime)
                rows += fmt::format("<td>{}</td>", point.gpuTime ? secondsText(*point.gpuTime, true) : "");
            if (hasMemory) rows += fmt::format("<td>{}</td>", point.memory ? bytesText(*point.memory) : "");
            rows += fmt::format("<td class=\"mark\">{}</td></tr>\n", point.isOnFront ? "front" : "");
        }
    const std::string unit =
        figure.errorUnit.empty() ? "" : fmt::format(" ({})", base::escapeXml(figure.errorUnit));
    return fmt::format(
        "<details><summary>{} points</summary><div class=\"table\"><table><thead><tr><th>curve</th>"
        "<th>{}</th><th class=\"number\">{}{}</th>{}{}{}<th></th></tr></thead><tbody>\n{}</tbody></table>"
        "</div></details>\n",
        count, base::escapeXml(figure.settingName), base::escapeXml(figure.errorName), unit,
        hasTime ? "<th class=\"number\">median time</th>" : "",
        hasGpuTime ? "<th class=\"number\">GPU time</th>" : "",
        hasMemory ? "<th class=\"number\">memory</th>" : "", rows);
}

/// In the order of Alternatives.
constexpr std::string_view kFrontNotes[] = {
    "", " Each curve has a front of its own.",
    " Each setting has a front of its own: it is a difficulty, not a cost.",
    " There is no front, because nothing of it is to be chosen."};

std::string section(const Figure& figure, const std::string& subject) {
    std::string html = fmt::format("<article id=\"{0}.{1}\"><h3>{2}</h3>\n", base::escapeXml(subject),
                                   base::escapeXml(figure.name), base::escapeXml(figure.title));
    html += list(figure.findings, "findings");
    html += "<div class=\"plots\">" + plot(figure, Abscissa::setting) + plot(figure, Abscissa::time) +
            "</div>\n" + legend(figure);
    if (!figure.reference.empty())
        html +=
            fmt::format("<p class=\"reference\">Reference: {}.{}</p>\n", base::escapeXml(figure.reference),
                        kFrontNotes[static_cast<std::size_t>(figure.alternatives)]);
    return html + table(figure) + "</article>\n";
}

std::string section(const SubjectRun& subject) {
    std::string html = fmt::format("<section id=\"{}\"><h2>{}</h2>\n", base::escapeXml(subject.name),
                                   base::escapeXml(subject.title));
    std::vector<std::string> problems;
    for (const Diagnostic& each : subject.diagnostics) problems.push_back(toString(each));
    html += list(problems, "problems");
    for (const Figure& figure : subject.figures) html += section(figure, subject.name);
    return html + "</section>\n";
}

std::string contents(const Report& report) {
    std::string html;
    for (const SubjectRun& subject : report.subjects) {
        html += fmt::format("<li><a href=\"#{}\">{}</a><ul>", base::escapeXml(subject.name),
                            base::escapeXml(subject.title.substr(0, subject.title.find(':'))));
        for (const Figure& figure : subject.figures)
            html += fmt::format("<li><a href=\"#{}.{}\">{}</a></li>", base::escapeXml(subject.name),
                                base::escapeXml(figure.name), base::escapeXml(figure.title));
        html += "</ul></li>\n";
    }
    return html;
}

std::string comparisonSection(const RunComparison& comparison) {
    return fmt::format(
        "<section id=\"comparison\"><h2>Against the earlier run: {}</h2><pre>{}</pre></section>\n",
        isWorse(comparison) ? "worse" : "nothing is worse", base::escapeXml(comparisonText(comparison)));
}

}  // namespace

std::string htmlReport(const Report& report, const RunComparison* comparison) {
    std::string body = comparison ? comparisonSection(*comparison) : std::string();
    std::size_t figures = 0, points = 0;
    for (const SubjectRun& subject : report.subjects) {
        body += section(subject);
        figures += subject.figures.size();
        for (const Figure& figure : subject.figures)
            for (const Curve& curve : figure.curves) points += curve.points.size();
    }
    const base::Slot slots[] = {
        {"style", std::string(bench_page::bench_css())},
        {"script", std::string(bench_page::bench_js())},
        {"extent", base::counted(report.subjects.size(), "subject") + ", " +
                       base::counted(figures, "diagram") + ", " + base::counted(points, "measured point")},
        {"machine", machineDetails(report)},
        {"contents", contents(report)},
        {"body", std::move(body)},
    };
    return base::filled(bench_page::page_html(), slots);
}

}  // namespace glibra::bench
