#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <nlohmann/json.hpp>

#include "bench/core/run.h"

namespace glibra::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kReportFormat = "glibra-bench-1";

/// In the order of Alternatives.
constexpr std::array kAlternativeWords{"figure", "curve", "setting", "none"};

// The members of each type under their names: what is written is what is read.

template <class Type, class Of>
concept Is = std::same_as<std::remove_const_t<Type>, Of>;

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
        return diagnose("bench-E02", "not valid JSON: " + plainText(problem),
                        placeOfByte(text, problem.byte, file));
    } catch (const Json::exception& problem) {
        return diagnose("bench-E02", "this is not a run of glibra bench: " + plainText(problem),
                        {file, 1, 1});
    }
}

}  // namespace glibra::bench
