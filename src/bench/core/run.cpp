#include "bench/core/run.h"

#include <fmt/chrono.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>
#include <type_traits>

#include "base/device_lost.h"
#include "system/places.h"

namespace glibra::bench {
namespace {

std::string compilerVersion() {
#if defined(__clang__)
    return fmt::format("Clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
    return fmt::format("GCC {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
    return {};
#endif
}

/// Processor, memory, operating system and compiler. The driver's members stay empty.
Machine describeMachine() {
    Machine machine;
    machine.processor = system::processorModel();
    machine.cores = static_cast<int>(std::thread::hardware_concurrency());
    machine.memory = static_cast<double>(system::machineMemory());
    machine.system = system::systemName();
    machine.compiler = compilerVersion();
    return machine;
}

void nameDriver(Machine& machine, Bench& bench) {
    try {
        const gpu::Capabilities& capabilities = bench.capabilities();
        machine.driver = bench.context().howOpened();
        machine.renderer = capabilities.renderer;
        machine.version = capabilities.version;
    } catch (const Failed&) {  // the subject says why
    }
}

/// What the other process needs: it was forked from this one, so addresses are the same.
struct Request {
    Subject subject;
    BenchOptions options;
};
static_assert(std::is_trivially_copyable_v<Request>);

Diagnostic failureOf(const Subject& subject, const std::string& why) {
    return diagnose("bench-E04", fmt::format("subject '{}' {}", subject.name, why));
}

Report failed(const Subject& subject, Diagnostic why) {
    Report report;
    report.subjects.push_back({std::string(subject.name), std::string(subject.title), 0, {}, {}});
    report.subjects.back().diagnostics.push_back(std::move(why));
    return report;
}

Report measuredHere(const Request& request) {
    return runOne(std::string(request.subject.name), std::string(request.subject.title),
                  request.subject.measure, request.options);
}

std::string answerTo(const std::string& text) {
    Request request;
    std::memcpy(&request, text.data(), sizeof request);
    try {
        return jsonReport(measuredHere(request));
    } catch (const base::DeviceLost& lost) {
        return jsonReport(failed(request.subject, base::diagnosticOf(lost, {})));
    } catch (const std::exception& failure) {
        return jsonReport(
            failed(request.subject, failureOf(request.subject, std::string("failed: ") + failure.what())));
    }
}

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

Report runOne(const std::string& name, const std::string& title,
              const std::function<std::vector<Figure>(Bench&)>& measure, const BenchOptions& options) {
    using Steady = std::chrono::steady_clock;
    Bench bench(options);
    Report report;
    report.quick = options.quick;
    report.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    report.machine = describeMachine();
    nameDriver(report.machine, bench);
    const Steady::time_point start = Steady::now();
    SubjectRun& done = report.subjects.emplace_back(SubjectRun{name, title});
    bench.attempt([&] { done.figures = measure(bench); });
    done.seconds = std::chrono::duration<double>(Steady::now() - start).count();
    done.diagnostics = bench.problems();
    for (Figure& figure : done.figures) {
        markFront(figure);
        if (std::string advice = recommendation(figure); !advice.empty())
            figure.findings.push_back(std::move(advice));
    }
    return report;
}

bool lacksDriver(const Report& report) {
    return std::ranges::any_of(report.subjects, [](const SubjectRun& subject) {
        return std::ranges::any_of(subject.diagnostics,
                                   [](const Diagnostic& each) { return each.id == "gpu-E01"; });
    });
}

Report runApart(Apart& apart, const Subject& subject, const BenchOptions& options) {
    const Request request{subject, options};
    if (!apart.isThere()) return measuredHere(request);
    std::string text(sizeof request, '\0');
    std::memcpy(text.data(), &request, sizeof request);
    const std::optional<std::string> answer = apart.run(answerTo, text);
    if (!answer) return failed(subject, failureOf(subject, apart.failure()));
    Result<Report> report = readJsonReport(*answer, std::string(subject.name));
    return report ? std::move(*report) : failed(subject, report.diagnostics.front());
}

std::optional<std::vector<Point>> filteredInBytes(Bench& bench, Bench::Measure measure) {
    if (bench.capabilities().family.find("llvmpipe") == std::string::npos || !bench.apart().isThere())
        return std::nullopt;
    BenchOptions options = bench.options();
    options.driver = bench.context().driver();
    options.filtersInBytes = true;
    const SubjectRun run = runApart(bench.apart(), {"bytes", "bytes", measure}, options).subjects.front();
    for (Diagnostic each : run.diagnostics) {
        each.severity = Severity::warning;  // the rest of the subject is measured all the same
        bench.report({std::move(each)});
    }
    if (hasError(run.diagnostics) || run.figures.empty()) return std::nullopt;
    return run.figures.front().curves.front().points;
}

Report run(std::span<const Subject* const> chosen, const BenchOptions& options, const Progress& progress) {
    Apart apart;  // while no driver is loaded
    Report all;
    all.quick = options.quick;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (progress.begins) progress.begins(*chosen[i], i, chosen.size());
        Report one = runApart(apart, *chosen[i], options);
        all.subjects.push_back(std::move(one.subjects.front()));
        if (all.machine.driver.empty() && !one.machine.processor.empty()) all.machine = one.machine;
        if (all.date.empty()) all.date = one.date;
        if (progress.measured) progress.measured(all);
    }
    return all;
}

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
