#include "bench/report/json_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace glibra::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kReportFormat = "glibra-bench-1";

Json written(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? Json(nullptr) : Json("inf");
}

/// In the order of Alternatives.
constexpr std::array kAlternativeWords{"figure", "curve", "setting", "none"};

Json written(const Curve& curve);
Json written(const Figure& figure);
Json written(const Diagnostic& each);
Json written(const SubjectRun& subject);

Json written(const Point& point) {
    Json json = {
        {"setting", written(point.setting)}, {"label", point.label}, {"error", written(point.error)}};
    if (point.time)
        json["time"] = {{"median", point.time->median},
                        {"low", point.time->low},
                        {"high", point.time->high},
                        {"repeats", point.time->repeats}};
    if (point.memory) json["memory"] = *point.memory;
    if (point.gpuTime) json["gpuTime"] = *point.gpuTime;
    json["front"] = point.isOnFront;
    return json;
}

template <class List>
Json writtenList(const List& list) {
    Json array = Json::array();
    for (const auto& each : list) array.push_back(written(each));
    return array;
}

Json written(const Curve& curve) {
    Json json = {{"name", curve.name}, {"points", writtenList(curve.points)}};
    if (curve.theoryOf) json["theoryOf"] = *curve.theoryOf;
    return json;
}

Json written(const Figure& figure) {
    return {{"name", figure.name},
            {"title", figure.title},
            {"settingName", figure.settingName},
            {"errorName", figure.errorName},
            {"errorUnit", figure.errorUnit},
            {"reference", figure.reference},
            {"findings", figure.findings},
            {"alternatives", kAlternativeWords.at(static_cast<std::size_t>(figure.alternatives))},
            {"curves", writtenList(figure.curves)}};
}

Json written(const Diagnostic& each) {
    Json json = {{"severity", name(each.severity)}, {"id", each.id}, {"text", each.text}};
    if (!each.place.file.empty())
        json["place"] = {{"file", each.place.file}, {"line", each.place.line}, {"column", each.place.column}};
    return json;
}

Json written(const SubjectRun& subject) {
    return {{"name", subject.name},
            {"title", subject.title},
            {"seconds", subject.seconds},
            {"diagnostics", writtenList(subject.diagnostics)},
            {"figures", writtenList(subject.figures)}};
}

Json written(const Machine& machine) {
    return {{"processor", machine.processor}, {"cores", machine.cores},       {"memory", machine.memory},
            {"system", machine.system},       {"compiler", machine.compiler}, {"driver", machine.driver},
            {"renderer", machine.renderer},   {"version", machine.version}};
}

// Reading. nlohmann's exceptions, which name the member, report wrong types.

double readNumber(const Json& json) {
    if (json.is_null()) return std::numeric_limits<double>::quiet_NaN();
    if (json == "inf") return std::numeric_limits<double>::infinity();
    return json.get<double>();
}

template <class Value>
void readMember(const Json& json, const char* key, Value& to) {
    if (const auto member = json.find(key); member != json.end()) member->get_to(to);
}

Point readPoint(const Json& json) {
    Point point;
    point.setting = readNumber(json.at("setting"));
    json.at("label").get_to(point.label);
    point.error = readNumber(json.at("error"));
    if (const auto time = json.find("time"); time != json.end()) {
        point.time.emplace();
        time->at("median").get_to(point.time->median);
        time->at("low").get_to(point.time->low);
        time->at("high").get_to(point.time->high);
        readMember(*time, "repeats", point.time->repeats);
    }
    if (const auto memory = json.find("memory"); memory != json.end()) point.memory = memory->get<double>();
    if (const auto time = json.find("gpuTime"); time != json.end()) point.gpuTime = time->get<double>();
    readMember(json, "front", point.isOnFront);
    return point;
}

Curve readCurve(const Json& json) {
    Curve curve;
    json.at("name").get_to(curve.name);
    for (const Json& each : json.at("points")) curve.points.push_back(readPoint(each));
    if (const auto of = json.find("theoryOf"); of != json.end()) curve.theoryOf = of->get<std::size_t>();
    return curve;
}

Figure readFigure(const Json& json) {
    Figure figure;
    json.at("name").get_to(figure.name);
    readMember(json, "title", figure.title);
    readMember(json, "settingName", figure.settingName);
    readMember(json, "errorName", figure.errorName);
    readMember(json, "errorUnit", figure.errorUnit);
    readMember(json, "reference", figure.reference);
    readMember(json, "findings", figure.findings);
    if (const auto kind = json.find("alternatives"); kind != json.end())
        for (std::size_t i = 0; i < kAlternativeWords.size(); ++i)
            if (*kind == kAlternativeWords.at(i)) figure.alternatives = static_cast<Alternatives>(i);
    for (const Json& each : json.at("curves")) figure.curves.push_back(readCurve(each));
    return figure;
}

Diagnostic readDiagnostic(const Json& json) {
    const auto severity = json.at("severity").get<std::string>();
    Diagnostic diagnostic{severity == "error"     ? Severity::error
                          : severity == "warning" ? Severity::warning
                                                  : Severity::note,
                          json.at("id").get<std::string>(),
                          json.at("text").get<std::string>(),
                          {}};
    if (const auto place = json.find("place"); place != json.end()) {
        readMember(*place, "file", diagnostic.place.file);
        readMember(*place, "line", diagnostic.place.line);
        readMember(*place, "column", diagnostic.place.column);
    }
    return diagnostic;
}

SubjectRun readSubject(const Json& json) {
    SubjectRun subject;
    json.at("name").get_to(subject.name);
    readMember(json, "title", subject.title);
    readMember(json, "seconds", subject.seconds);
    for (const Json& each : json.at("figures")) subject.figures.push_back(readFigure(each));
    if (const auto found = json.find("diagnostics"); found != json.end())
        for (const Json& each : *found) subject.diagnostics.push_back(readDiagnostic(each));
    return subject;
}

Machine readMachine(const Json& json) {
    Machine machine;
    readMember(json, "processor", machine.processor);
    readMember(json, "cores", machine.cores);
    readMember(json, "memory", machine.memory);
    readMember(json, "system", machine.system);
    readMember(json, "compiler", machine.compiler);
    readMember(json, "driver", machine.driver);
    readMember(json, "renderer", machine.renderer);
    readMember(json, "version", machine.version);
    return machine;
}

Report readReport(const Json& json) {
    Report report;
    readMember(json, "glibra", report.glibra);
    readMember(json, "date", report.date);
    readMember(json, "quick", report.quick);
    report.machine = readMachine(json.at("machine"));
    for (const Json& each : json.at("subjects")) report.subjects.push_back(readSubject(each));
    return report;
}

Place placeOfByte(std::string_view text, std::size_t byte, const std::string& file) {
    const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
    const auto line = std::ranges::count(before, '\n');
    const std::size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0
    return {file, static_cast<int>(line) + 1, static_cast<int>(before.size() - lineStart) + 1};
}

/// The text of nlohmann's exception without its "[json.exception.NAME.NUMBER] ".
std::string plainText(const Json::exception& problem) {
    const std::string text = problem.what();
    const std::size_t end = text.find("] ");
    return end == std::string::npos ? text : text.substr(end + 2);
}

}  // namespace

std::string jsonReport(const Report& report) {
    const Json json = {{"format", kReportFormat},
                       {"glibra", report.glibra},
                       {"date", report.date},
                       {"quick", report.quick},
                       {"machine", written(report.machine)},
                       {"subjects", writtenList(report.subjects)}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Report> readJsonReport(std::string_view text, const std::string& file) {
    try {
        const Json json = Json::parse(text);
        if (!json.is_object() || json.value("format", "") != kReportFormat)
            return diagnose("bench-E02", "this is not a run of glibra bench; --against takes its bench.json",
                            {file, 1, 1});
        return readReport(json);
    } catch (const Json::parse_error& problem) {
        return diagnose("bench-E02", "not valid JSON: " + plainText(problem),
                        placeOfByte(text, problem.byte, file));
    } catch (const Json::exception& problem) {
        return diagnose("bench-E02", "this is not a run of glibra bench: " + plainText(problem),
                        {file, 1, 1});
    }
}

}  // namespace glibra::bench
