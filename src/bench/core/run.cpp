#include "bench/core/run.h"

#include <fmt/chrono.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <concepts>
#include <cstring>
#include <ctime>
#include <limits>
#include <thread>
#include <type_traits>

#include "base/device_lost.h"
#include "base/packed.h"
#include "base/text.h"
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
            failed(request.subject, failureOf(request.subject, "failed: " + base::reasonOf(failure))));
    }
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

/// The same in the process of `apart`, or in this one if there is none. bench-E04: it ended by a signal or an
/// exception.
static Report runApart(Apart& apart, const Subject& subject, const BenchOptions& options) {
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

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kReportFormat = "glibra-bench-1";

/// In the order of Alternatives.
constexpr std::array kAlternativeWords{"figure", "curve", "setting", "none"};

// The members of each type under their names: what is written is what is read.

using base::Is;

void members(Is<Timing> auto& of, const auto& visit) {
    visit("median", of.median)("low", of.low)("high", of.high)("repeats", of.repeats);
}
void members(Is<Point> auto& of, const auto& visit) {
    visit("setting", of.setting)("label", of.label)("error", of.error)("time", of.time);
    visit("memory", of.memory)("gpuTime", of.gpuTime)("front", of.isOnFront);
}
void members(Is<Curve> auto& of, const auto& visit) {
    visit("name", of.name)("points", of.points)("theoryOf", of.theoryOf);
}
void members(Is<Figure> auto& of, const auto& visit) {
    visit("name", of.name)("title", of.title)("settingName", of.settingName)("errorName", of.errorName);
    visit("errorUnit", of.errorUnit)("reference", of.reference)("findings", of.findings);
    visit("alternatives", of.alternatives)("curves", of.curves);
}
void members(Is<Place> auto& of, const auto& visit) {
    visit("file", of.file)("line", of.line)("column", of.column);
}
void members(Is<Diagnostic> auto& of, const auto& visit) {
    visit("severity", of.severity)("id", of.id)("text", of.text)("place", of.place);
}
void members(Is<SubjectRun> auto& of, const auto& visit) {
    visit("name", of.name)("title", of.title)("seconds", of.seconds)("diagnostics", of.diagnostics);
    visit("figures", of.figures);
}
void members(Is<Machine> auto& of, const auto& visit) {
    visit("processor", of.processor)("cores", of.cores)("memory", of.memory)("system", of.system);
    visit("compiler", of.compiler)("driver", of.driver)("renderer", of.renderer)("version", of.version);
}
void members(Is<Report> auto& of, const auto& visit) {
    visit("glibra", of.glibra)("date", of.date)("quick", of.quick)("machine", of.machine);
    visit("subjects", of.subjects);
}

template <class Value>
Json written(const Value& value);
template <class Value>
Json written(const std::vector<Value>& values);

/// Adds members to a JSON object, without those that are absent.
struct Writer {
    Json& json;

    template <class Value>
    const Writer& operator()(const char* key, const Value& value) const {
        json[key] = written(value);
        return *this;
    }
    template <class Value>
    const Writer& operator()(const char* key, const std::optional<Value>& value) const {
        return value ? (*this)(key, *value) : *this;
    }
    const Writer& operator()(const char* key, const Place& place) const {
        if (!place.file.empty()) json[key] = written(place);
        return *this;
    }
};

template <class Value>
Json written(const std::vector<Value>& values) {
    Json array = Json::array();
    for (const Value& each : values) array.push_back(written(each));
    return array;
}

template <class Value>
Json written(const Value& value) {
    if constexpr (std::same_as<Value, double>) {
        return std::isfinite(value) ? Json(value) : std::isnan(value) ? Json(nullptr) : Json("inf");
    } else if constexpr (std::same_as<Value, Severity>) {
        return name(value);
    } else if constexpr (std::same_as<Value, Alternatives>) {
        return kAlternativeWords.at(static_cast<std::size_t>(value));
    } else if constexpr (std::same_as<Value, std::string> || !std::is_class_v<Value>) {
        return value;
    } else {
        Json json;
        members(value, Writer{json});
        return json;
    }
}

// Reading. nlohmann's exceptions, which name the member, report wrong types.

template <class Value>
void read(const Json& json, Value& to);

/// Reads members of a JSON object. Numbers and lists must be there; others keep what they are.
struct Reader {
    const Json& json;

    template <class Value>
    const Reader& operator()(const char* key, Value& to) const {
        constexpr bool isNeeded = std::same_as<Value, double>;
        if (isNeeded || json.contains(key)) read(json.at(key), to);
        return *this;
    }
    template <class Value>
    const Reader& operator()(const char* key, std::optional<Value>& to) const {
        if (json.contains(key)) read(json.at(key), to.emplace());
        return *this;
    }
    template <class Value>
    const Reader& operator()(const char* key, std::vector<Value>& to) const {
        for (const Json& each : json.at(key)) read(each, to.emplace_back());
        return *this;
    }
};

template <class Value>
void read(const Json& json, Value& to) {
    if constexpr (std::same_as<Value, double>) {
        to = json.is_null()  ? std::numeric_limits<double>::quiet_NaN()
             : json == "inf" ? std::numeric_limits<double>::infinity()
                             : json.get<double>();
    } else if constexpr (std::same_as<Value, Severity>) {
        to = json == "error" ? Severity::error : json == "warning" ? Severity::warning : Severity::note;
    } else if constexpr (std::same_as<Value, Alternatives>) {
        for (std::size_t i = 0; i < kAlternativeWords.size(); ++i)
            if (json == kAlternativeWords.at(i)) to = static_cast<Alternatives>(i);
    } else if constexpr (std::same_as<Value, std::string> || !std::is_class_v<Value>) {
        json.get_to(to);
    } else {
        members(to, Reader{json});
    }
}

}  // namespace

std::string jsonReport(const Report& report) {
    Json json{{"format", kReportFormat}};
    members(report, Writer{json});
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Report> readJsonReport(std::string_view text, const std::string& file) {
    try {
        const Json json = Json::parse(text);
        if (!json.is_object() || json.value("format", "") != kReportFormat)
            return diagnose("bench-E02", "this is not a run of glibra bench; --against takes its bench.json",
                            {file, 1, 1});
        Report report;
        members(report, Reader{json});
        return report;
    } catch (const Json::parse_error& problem) {
        return diagnose("bench-E02", "not valid JSON: " + base::reasonOf(problem),
                        base::placeOfByte(text, problem.byte, file));
    } catch (const Json::exception& problem) {
        return diagnose("bench-E02", "this is not a run of glibra bench: " + base::reasonOf(problem),
                        {file, 1, 1});
    }
}

}  // namespace glibra::bench
