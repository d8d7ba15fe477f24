#include "suite/results/results_file.h"

#include <fmt/format.h>
#include <cerrno>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <type_traits>
#include <utility>

#include "base/files.h"
#include "base/text.h"
#include "base/utf8.h"
#include "image/file.h"
#include "suite/golden/hash_list.h"
#include "suite/write_below.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostMistakes = 20;
constexpr std::uint64_t kLargestResults = 1ULL << 30;
/// A loss of power costs the results since the last write to the disk. Writing each of them there would take
/// longer than drawing it on some disks.
constexpr std::chrono::seconds kSyncInterval{1};

Diagnostics makeFolder(const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    std::error_code unknown;
    if (failed && !fs::is_directory(folder, unknown)) return {cannotWrite(folder, failed.value())};
    return {};
}

Diagnostics writeWhole(const RunResult& run, const fs::path& file) {
    std::string text = toJsonLine(run) + '\n';
    for (const ShotResult& shot : run.shots) text += toJsonLine(shot) + '\n';
    if (run.complete) text += endLine(run.shots.size()) + '\n';
    return writeBelow(file.parent_path(), file.filename(), std::as_bytes(std::span(text)));
}

}  // namespace

fs::path resultsFile(const fs::path& folder) {
    std::error_code ignored;
    return fs::is_regular_file(folder, ignored) ? folder : folder / "results.jsonl";
}

Diagnostic cannotShow(const fs::path& path, int problem) {
    const std::string name = path.generic_string();
    switch (problem) {
        case ENOENT:
        case ENOTDIR:
            return diagnose("file-E01", fmt::format("cannot find '{}'", name));
        case EACCES:
        case EINVAL:
            return diagnose(
                "file-E14",
                fmt::format("cannot read '{}': it is not in the folder of the results, nor below the "
                            "folders of the suite, its scenes and the library",
                            name));
        case ELOOP:
            return diagnose("file-E14", fmt::format("cannot read '{}': links are not followed here", name));
        case ENOTSUP:
            return diagnose("file-E14", fmt::format("cannot read '{}': it is not an ordinary file", name));
        case EFBIG:
            return diagnose("file-E09", fmt::format("'{}' is too large to be shown", name));
        default:
            return diagnose("file-E14", fmt::format("cannot read '{}': {}", name,
                                                    std::generic_category().message(problem)));
    }
}

Result<std::vector<std::byte>> readNamed(const fs::path& path, const fs::path& resultsFolder,
                                         const base::Roots& roots, std::uint64_t largest) {
    base::Roots results;
    results.add(resultsFolder);
    system::File file = results.open(resultsFolder / path);  // the path itself if it is absolute
    int problem = file ? 0 : errno;
    if (!file && (problem == ENOENT || problem == ENOTDIR || problem == EACCES)) {
        file = roots.open(path);
        // What is neither in the results nor below a root is missing for a path into the results.
        if (!file && (errno != EACCES || problem == EACCES)) problem = errno;
    }
    if (!file) return cannotShow(path, problem);
    std::vector<std::byte> bytes;
    problem = base::readAll(file, largest, bytes);
    if (problem != 0) return cannotShow(path, problem);
    return bytes;
}

Diagnostics writeResults(const RunResult& run, const fs::path& folder) {
    if (Diagnostics problems = makeFolder(folder); !problems.empty()) return problems;
    return writeWhole(run, resultsFile(folder));
}

Result<RunResult> readResults(const fs::path& folder) {
    const std::string file = resultsFile(folder).generic_string();
    std::error_code ignored;
    if (fs::is_symlink(file, ignored)) return cannotShow(file, ELOOP);
    const Result<std::vector<std::byte>> bytes = image::readFile(file, {file, {}}, kLargestResults);
    if (!bytes) return bytes.diagnostics;
    std::string_view rest = base::asText(*bytes);
    Result<RunResult> result;
    std::map<ShotKey, std::size_t> known;
    for (int number = 1; !rest.empty() && result.diagnostics.size() < kMostMistakes; ++number) {
        const bool isTorn = rest.find('\n') == std::string_view::npos;
        const std::string_view line = base::nextLine(rest);
        const Place place{file, number, 1};
        if (number == 1) {
            Result<RunResult> run = parseRunLine(line, place);
            if (!run) return run.diagnostics;
            result.value = std::move(run.value);
            continue;
        }
        if (result->complete) {
            result.diagnostics.push_back(
                diagnose("result-E01", "this line stands after the end line", place));
            break;
        }
        if (const std::optional<std::size_t> count = parseEndLine(line)) {
            result->complete = true;
            if (*count != result->shots.size())
                result.diagnostics.push_back(
                    diagnose("result-E01",
                             fmt::format("the end line counts {} shots, but the file has {}", *count,
                                         result->shots.size()),
                             place));
            continue;
        }
        Result<ShotResult> shot = parseJsonLine(line, place);
        if (!shot && isTorn) {
            result.diagnostics.push_back(
                diagnose("result-N01", "the last line is torn, so its shot is not counted", place));
        } else if (!shot) {
            append(result.diagnostics, std::move(shot.diagnostics));
        } else {
            std::vector<ShotResult>& shots = result->shots;
            const auto [at, isNew] = known.try_emplace({shot->suite, shot->shot}, shots.size());
            if (isNew)
                shots.push_back(std::move(*shot));
            else
                shots[at->second] = std::move(*shot);
        }
    }
    if (hasError(result.diagnostics)) result.value.reset();
    return result;
}

Result<ResultsLock> lockResults(const fs::path& folder) {
    if (Diagnostics problems = makeFolder(folder); !problems.empty()) return problems;
    ResultsLock lock;
    // Only a lock that another process holds is a reason to stop, because some file systems have no locks.
    if (lock.takeFolder(folder, ResultsLock::Wait::no) == ResultsLock::Try::held)
        return diagnose(
            "result-E02",
            fmt::format("another run is writing its results to '{}'; give each run a folder of its own",
                        folder.generic_string()));
    return lock;
}

Result<ResultsWriter> ResultsWriter::open(const fs::path& folder, const RunResult& run, Start start) {
    Result<ResultsLock> lock = lockResults(folder);
    if (!lock) return std::move(lock.diagnostics);
    const fs::path path = resultsFile(folder);
    RunResult beginning = run;
    beginning.shots.clear();
    beginning.complete = false;
    std::error_code failed;
    if (start == Start::resumed && fs::exists(path, failed) && fs::file_size(path, failed) > 0) {
        Result<RunResult> earlier = readResults(path);
        if (!earlier) return earlier.diagnostics;
        beginning.shots = std::move(earlier->shots);
    }
    if (Diagnostics problems = writeWhole(beginning, path); !problems.empty()) return problems;
    system::File file = system::openToAppend(path);
    if (!file) return cannotWrite(path, errno);
    return ResultsWriter(path, std::move(*lock), std::move(file));
}

Diagnostics ResultsWriter::add(const ShotResult& shot) {
    if (const int problem = appendWhole(file_, toJsonLine(shot) + '\n'); problem != 0)
        return {cannotWrite(path_, problem)};
    if (const auto now = std::chrono::steady_clock::now(); now - synced_ >= kSyncInterval) {
        // A disk that fails is reported by the write of the whole file at the end.
        syncContent(file_);
        synced_ = now;
    }
    return {};
}

ResultsWriter::ResultsWriter(fs::path path, ResultsLock lock, system::File file)
    : path_(std::move(path)),
      lock_(std::move(lock)),
      file_(std::move(file)),
      synced_(std::chrono::steady_clock::now()) {}

// The JSON lines of results. Each structure names its members once, for writing and for reading.

namespace {

using Json = nlohmann::ordered_json;

// A run writes no larger numbers; a results file that holds one was not written by a run.
constexpr double kLongestTime = 1e9;  ///< seconds
constexpr int kLargestSide = 1 << 24;
constexpr int kMostLines = std::numeric_limits<int>::max();

template <class T>
concept Integer = std::is_integral_v<T> && !std::is_same_v<T, bool>;

constexpr std::pair<image::Rung, const char*> kRungs[] = {{image::Rung::size, "size"},
                                                          {image::Rung::bytes, "bytes"},
                                                          {image::Rung::differences, "differences"},
                                                          {image::Rung::bias, "bias"},
                                                          {image::Rung::structure, "structure"},
                                                          {image::Rung::flip, "flip"}};

template <class Archive, class Value>
void members(Archive& archive, Value& value);

Json written(const std::string& text) {
    if (base::isUtf8(text)) return text;
    std::string characters;
    for (const char byte : text) base::appendUtf8(characters, static_cast<unsigned char>(byte));
    return {{"bytes", characters}};
}
Json written(const std::filesystem::path& path) {
    return written(path.generic_string());
}
Json written(bool value) {
    return value;
}
template <Integer Number>
Json written(Number value) {
    return value;
}
Json written(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}
Json written(Verdict verdict) {
    return name(verdict);
}
Json written(Severity severity) {
    return name(severity);
}
Json written(image::Rung rung) {
    for (const auto& [each, word] : kRungs)
        if (each == rung) return word;
    return nullptr;
}

/// Makes a JSON object of a structure.
struct Writer {
    Json object = Json::object();

    template <class Value>
    static Json toJson(const Value& value) {
        if constexpr (requires { written(value); }) {
            return written(value);
        } else {
            Writer inner;
            members(inner, value);
            return std::move(inner.object);
        }
    }
    template <class Value>
    static Json toJson(const std::optional<Value>& value) {
        return value ? toJson(*value) : Json(nullptr);
    }
    template <class Value>
    static Json toJson(const std::vector<Value>& list) {
        Json array = Json::array();
        for (const Value& each : list) array.push_back(toJson(each));
        return array;
    }
    template <class Value>
    void operator()(const char* key, const Value& value) {
        object[key] = toJson(value);
    }
    template <class Value>
    void needed(const char* key, const Value& value) {
        (*this)(key, value);
    }
    template <class Number>
    void within(const char* key, const Number& value, Number) {
        (*this)(key, value);
    }
    void variant(const char* key, const std::string& value) { (*this)(key, value); }
};

/// What is wrong in a line.
struct Mistake {
    std::string text;
    bool isNamed = false;  ///< the text names the member
};

/// Fills a structure from a JSON object. Throws the first Mistake.
struct Reader {
    const Json& object;

    [[noreturn]] static void fail(std::string what) { throw Mistake{std::move(what)}; }

    static void read(const Json& json, std::string& to) {
        if (json.is_string()) {
            to = json.get_ref<const std::string&>();
            return;
        }
        const auto bytes = json.is_object() ? json.find("bytes") : json.end();
        if (!json.is_object() || bytes == json.end() || !bytes->is_string()) fail("expected a string");
        to.clear();
        std::string_view rest = bytes->get_ref<const std::string&>();
        while (!rest.empty()) {
            const base::Character next = base::firstCharacter(rest);
            if (next.code > 0xFF) fail("\"bytes\" holds a character above U+00FF");
            to += static_cast<char>(next.code);
            rest.remove_prefix(next.bytes);
        }
    }
    static void read(const Json& json, std::filesystem::path& to) {
        std::string text;
        read(json, text);
        to = text;
    }
    static void read(const Json& json, bool& to) {
        if (!json.is_boolean()) fail("expected true or false");
        to = json.get<bool>();
    }
    template <Integer Number>
    static void read(const Json& json, Number& to) {
        bool fits = false;
        if (json.is_number_unsigned())
            fits = std::in_range<Number>(json.get<std::uint64_t>());
        else if (json.is_number_integer())
            fits = std::in_range<Number>(json.get<std::int64_t>());
        if (!fits) fail("expected a whole number in its range");
        to = json.get<Number>();
    }
    static void read(const Json& json, double& to) {
        if (json.is_number())
            to = json.get<double>();
        else if (json == "inf")
            to = std::numeric_limits<double>::infinity();
        else if (json == "-inf")
            to = -std::numeric_limits<double>::infinity();
        else if (json == "nan")
            to = std::numeric_limits<double>::quiet_NaN();
        else
            fail("expected a number");
    }
    static void read(const Json& json, Verdict& to) {
        std::string word;
        read(json, word);
        const std::optional<Verdict> verdict = verdictOf(word);
        if (!verdict) fail(fmt::format("there is no verdict '{}'", word));
        to = *verdict;
    }
    static void read(const Json& json, Severity& to) {
        std::string word;
        read(json, word);
        for (const Severity each : {Severity::note, Severity::warning, Severity::error})
            if (word == name(each)) {
                to = each;
                return;
            }
        fail(fmt::format("there is no severity '{}'", word));
    }
    static void read(const Json& json, image::Rung& to) {
        std::string word;
        read(json, word);
        for (const auto& [each, known] : kRungs)
            if (word == known) {
                to = each;
                return;
            }
        fail(fmt::format("the comparison has no rung '{}'", word));
    }
    template <class Value>
    static void read(const Json& json, std::optional<Value>& to) {
        if (json.is_null())
            to.reset();
        else
            read(json, to.emplace());
    }
    template <class Value>
    static void read(const Json& json, std::vector<Value>& to) {
        if (!json.is_array()) fail("expected a list");
        to.clear();
        for (const Json& each : json) read(each, to.emplace_back());
    }
    template <class Value>
        requires std::is_class_v<Value>
    static void read(const Json& json, Value& to) {
        if (!json.is_object()) fail("expected an object");
        Reader inner{json};
        members(inner, to);
    }

    template <class Value>
    void operator()(const char* key, Value& value) {
        const auto member = object.find(key);
        if (member == object.end()) return;
        try {
            read(*member, value);
        } catch (Mistake& mistake) {
            if (!mistake.isNamed) mistake = {fmt::format("'{}': {}", key, mistake.text), true};
            throw;
        }
    }
    /// A number from 0 to `most`.
    template <class Number>
    void within(const char* key, Number& value, Number most) {
        (*this)(key, value);
        if (!(value >= 0 && value <= most))
            throw Mistake{fmt::format("'{}': expected a number between 0 and {}", key, most), true};
    }
    /// The variant of a golden, which names a file; empty: the golden for all drivers.
    void variant(const char* key, std::string& value) {
        (*this)(key, value);
        if (!isVariant(value))
            throw Mistake{fmt::format("'{}': expected a family of drivers, or also1 to also9", key), true};
    }
    template <class Value>
    void needed(const char* key, Value& value) {
        if (!object.contains(key)) fail(fmt::format("the member '{}' is missing", key));
        (*this)(key, value);
    }
};

template <class Archive, class Value>
void members(Archive& archive, Value& value) {
    using Type = std::remove_const_t<Value>;
    if constexpr (std::is_same_v<Type, Place>) {
        archive("file", value.file);
        archive.within("line", value.line, kMostLines);
        archive.within("column", value.column, kMostLines);
    } else if constexpr (std::is_same_v<Type, Diagnostic>) {
        archive("severity", value.severity);
        archive("id", value.id);
        archive("text", value.text);
        archive("place", value.place);
        archive("subject", value.subject);
        archive("suggestion", value.suggestion);
    } else if constexpr (std::is_same_v<Type, image::Comparison>) {
        archive("sameSize", value.sameSize);
        archive("identical", value.identical);
        archive("differingPixels", value.differingPixels);
        archive("largest", value.largest);
        archive("x", value.x);
        archive("y", value.y);
        archive("component", value.component);
        archive("rootMeanSquare", value.rootMeanSquare);
    } else if constexpr (std::is_same_v<Type, image::Judgement>) {
        archive("same", value.same);
        archive("decidedBy", value.decidedBy);
        archive("reason", value.reason);
        archive("comparison", value.comparison);
        archive("beyond", value.beyond);
        archive("cluster", value.cluster);
        archive("clusterX", value.clusterX);
        archive("clusterY", value.clusterY);
        archive("line", value.line);
        archive("bias", value.bias);
        archive("biasX", value.biasX);
        archive("biasY", value.biasY);
        archive("flip", value.flip);
        archive("structure", value.structure);
    } else if constexpr (std::is_same_v<Type, image::Tolerance>) {
        archive("largest", value.largest);
        archive("fraction", value.fraction);
        archive("cluster", value.cluster);
        archive("line", value.line);
        archive("bias", value.bias);
        archive("flip", value.flip);
        archive("structure", value.structure);
        archive("relative", value.relative);
        archive("absolute", value.absolute);
    } else if constexpr (std::is_same_v<Type, image::DifferenceSteps>) {
        archive("limits", value.limits);
        archive("pixels", value.pixels);
    } else if constexpr (std::is_same_v<Type, ShotResult>) {
        archive.needed("suite", value.suite);
        archive.needed("shot", value.shot);
        archive.needed("verdict", value.verdict);
        archive("reason", value.reason);
        archive("script", value.script);
        archive("got", value.got);
        archive("expected", value.expected);
        archive("difference", value.difference);
        archive.variant("goldenVariant", value.goldenVariant);
        archive("exact", value.exact);
        archive("changed", value.changed);
        archive.within("compared", value.compared, 1.);
        archive("renamedFrom", value.renamedFrom);
        archive("nearTo", value.nearTo);
        archive.within("width", value.width, kLargestSide);
        archive.within("height", value.height, kLargestSide);
        archive("judgement", value.judgement);
        archive("tolerance", value.tolerance);
        archive("steps", value.steps);
        archive("toPass", value.toPass);
        archive("noTolerance", value.noTolerance);
        archive("diagnostics", value.diagnostics);
        archive.within("milliseconds", value.milliseconds, 1000 * kLongestTime);
        archive("driver", value.driver);
        archive("fingerprint", value.fingerprint);
        archive("driverKey", value.driverKey);
        archive("reproduce", value.reproduce);
        archive("accept", value.accept);
        archive("acceptKey", value.acceptKey);
        archive("awaits", value.awaits);
        archive("awaitsStore", value.awaitsStore);
        archive("reads", value.reads);
    } else if constexpr (std::is_same_v<Type, PlannedShots>) {
        archive.needed("suite", value.suite);
        archive.needed("shots", value.shots);
        archive("file", value.file);
    } else if constexpr (std::is_same_v<Type, OrphanGolden>) {
        archive.needed("suite", value.suite);
        archive.needed("file", value.file);
    } else {
        static_assert(std::is_same_v<Type, RunResult>);
        archive("driver", value.driver);
        archive("machine", value.machine);
        archive("shard", value.shard);
        archive("plan", value.plan);
        archive("command", value.command);
        archive.within("seconds", value.seconds, kLongestTime);
        archive("began", value.began);
        archive("planned", value.planned);
        archive("missingShards", value.missingShards);
        archive("orphans", value.orphans);
    }
}

template <class Value>
Result<Value> parseObject(std::string_view line, const Place& place, const char* inside) {
    try {
        const Json json = Json::parse(line);
        if (!json.is_object()) Reader::fail("expected an object");
        if (inside && !json.contains(inside)) Reader::fail(fmt::format("the member '{}' is missing", inside));
        Value value;
        Reader::read(inside ? json.at(inside) : json, value);
        return value;
    } catch (const Json::parse_error&) {
        return diagnose("result-E01", line.empty() ? "this line is empty" : "this line is not JSON", place);
    } catch (const Json::exception&) {  // a number that is too large for any type
        return diagnose("result-E01", "this line holds a number that is too large", place);
    } catch (const Mistake& mistake) {
        return diagnose("result-E01", "this is not a line of results: " + mistake.text, place);
    }
}

}  // namespace

std::string toJsonLine(const ShotResult& shot) {
    return Writer::toJson(shot).dump();
}

std::string toJsonLine(const RunResult& run) {
    return Json{{"run", Writer::toJson(run)}}.dump();
}

Result<ShotResult> parseJsonLine(std::string_view line, const Place& place) {
    return parseObject<ShotResult>(line, place, nullptr);
}

Result<RunResult> parseRunLine(std::string_view line, const Place& place) {
    return parseObject<RunResult>(line, place, "run");
}

std::string endLine(std::size_t shots) {
    return Json{{"end", {{"shots", shots}}}}.dump();
}

std::optional<std::size_t> parseEndLine(std::string_view line) {
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object() || json.size() != 1 || !json.contains("end")) return std::nullopt;
    const Json& end = json.at("end");
    if (!end.is_object() || !end.contains("shots") || !end.at("shots").is_number_unsigned())
        return std::nullopt;
    return end.at("shots").get<std::size_t>();
}

}  // namespace glibra::suite
