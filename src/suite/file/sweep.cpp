#include "suite/file/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/text.h"
#include "glib/number.h"
#include "glib/text.h"
#include "image/file.h"
#include "plan/overrides.h"

namespace glibra::suite {
namespace {

constexpr std::size_t kMostLabelNumbers = 4;
constexpr std::size_t kMostNumbers = 4096;  // as --set

/// "Dots" or "12": a program's name or line, where letters and digits are enough for it.
bool isProgram(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) { return glib::isOfName(c) || c == '-'; });
}

/// A name as GLSL has it, with parts and indices: "uKd", "light.color", "uWeights[2]"; a program may stand
/// before it as for --set: "Dots:uKd".
bool isUniformName(std::string_view name) {
    if (const std::size_t colon = name.find(':'); colon != name.npos) {
        if (!isProgram(name.substr(0, colon))) return false;
        name.remove_prefix(colon + 1);
    }
    return !name.empty() && !glib::isDigit(name.front()) && std::ranges::all_of(name, [](char c) {
        return glib::isOfName(c) || std::string_view(".[]").find(c) != std::string_view::npos;
    });
}

std::string labelOf(const plan::Override& value, std::size_t index) {
    if (!value.word.empty()) return value.word;
    if (value.form == glib::UniformForm::truth) return value.values.front() != 0 ? "true" : "false";
    if (value.values.size() > kMostLabelNumbers) return fmt::format("v{}", index + 1);
    std::string label;
    for (const double each : value.values) label += (label.empty() ? "" : ",") + glib::numberText(each);
    return label;
}

/// The name in the name of a shot, where brackets and colons cannot stand: "uWeights.2".
std::string labelOf(std::string_view uniform) {
    std::string label;
    for (const char c : uniform)
        if (c != ']') label += c == '[' || c == ':' ? '.' : c;
    return label;
}

class UniformReader {
  public:
    UniformReader(TomlReader& reader, UniformTable kind) : reader_(reader), kind_(kind) {}

    void read(const TomlTable& table, const std::string& prefix) {
        for (const TomlEntry& entry : table) {
            const std::string name = prefix + entry.key;
            if (const auto* part = entry.value.as<TomlTable>()) {
                read(*part, name + '.');
            } else if (!isUniformName(name)) {
                reader_.report(
                    "suite-E05",
                    fmt::format("{}: {} is not the name of a uniform", word(), glib::inQuotes(name)),
                    entry.position);
            } else {
                readOne(name, entry);
            }
        }
    }

    std::vector<UniformValues> take() { return std::move(all_); }

  private:
    [[nodiscard]] std::string_view word() const { return kind_ == UniformTable::set ? "set" : "sweep"; }

    void readOne(const std::string& name, const TomlEntry& entry) {
        UniformValues uniform{name, {}, reader_.placeOf(entry.position)};
        const std::string called = fmt::format("{}.{}", word(), name);
        if (kind_ == UniformTable::set) {
            if (auto one = value(entry.value, name, called, 0)) {
                uniform.values.push_back(std::move(*one));
                all_.push_back(std::move(uniform));
            }
            return;
        }
        const auto* list = entry.value.as<TomlList>();
        if (!list) return reader_.wrongType(entry.value, called, "a list of values, as [0, 0.1, 0.2]");
        if (list->empty()) return reader_.report("suite-E04", called + ": the list is empty", entry.value);
        for (std::size_t i = 0; i < list->size(); ++i)
            if (auto one = value((*list)[i], name, called, i)) uniform.values.push_back(std::move(*one));
        if (uniform.values.size() == list->size()) all_.push_back(std::move(uniform));
    }

    /// A value at position `index` of a sweep, or of `set`.
    std::optional<UniformValue> value(const TomlValue& node, const std::string& name,
                                      const std::string& called, std::size_t index) {
        std::optional<std::string> text;
        if (const auto* list = node.as<TomlList>()) {
            text = listText(node, *list, called);
        } else if (node.as<std::string>()) {
            text = reader_.text(node, called);
        } else {
            text = scalarText(node, called, "a number, true, false, a list of numbers or a text");
        }
        if (!text) return std::nullopt;
        const Result<plan::Override> parsed = plan::parseOverride(name + "=" + *text);
        if (!parsed) {
            // The message begins with what the command line was given.
            std::string why = parsed.diagnostics.empty() ? "not a value" : parsed.diagnostics.front().text;
            const std::string given = fmt::format("--set {}={}: ", name, *text);
            if (why.starts_with(given)) why.erase(0, given.size());
            reader_.report("suite-E04", fmt::format("{}: {}: {}", called, glib::inQuotes(*text), why), node);
            return std::nullopt;
        }
        return UniformValue{std::move(*text), labelOf(*parsed, index)};
    }

    std::optional<std::string> listText(const TomlValue& node, const TomlList& list,
                                        const std::string& called) {
        if (list.empty() || list.size() > kMostNumbers) {
            reader_.report("suite-E04",
                           list.empty() ? called + ": the list is empty"
                                        : fmt::format("{}: {} numbers; the limit is {}", called, list.size(),
                                                      kMostNumbers),
                           node);
            return std::nullopt;
        }
        std::string text;
        for (const TomlValue& each : list) {
            if (each.as<TomlList>() && kind_ == UniformTable::set) {
                reader_.report("suite-E03",
                               called +
                                   ": expected one value, found a list of lists; a list of values belongs "
                                   "in sweep",
                               each);
                return std::nullopt;
            }
            const auto one = scalarText(each, called, "a number in the list");
            if (!one) return std::nullopt;
            text += (text.empty() ? "" : ",");
            text += *one == "true" ? "1" : *one == "false" ? "0" : *one;
        }
        return text;
    }

    std::optional<std::string> scalarText(const TomlValue& node, const std::string& called,
                                          std::string_view expected) {
        if (const auto* truth = node.as<bool>()) return *truth ? "true" : "false";
        if (const auto* whole = node.as<std::int64_t>()) return std::to_string(*whole);
        if (!node.as<double>()) {
            reader_.wrongType(node, called, expected);
            return std::nullopt;
        }
        const double number = *node.as<double>();
        if (!std::isfinite(static_cast<float>(number))) {
            reader_.report(
                "suite-E04",
                fmt::format("{}: {} is not a finite 32-bit number", called, glib::numberText(number)), node);
            return std::nullopt;
        }
        return glib::numberText(number);
    }

    TomlReader& reader_;
    UniformTable kind_;
    std::vector<UniformValues> all_;
};

}  // namespace

std::vector<UniformValues> readUniforms(TomlReader& reader, const TomlTable& table, UniformTable kind) {
    UniformReader uniforms(reader, kind);
    uniforms.read(table, "");
    return uniforms.take();
}

std::uint64_t combinationCount(std::span<const UniformValues> sweeps) {
    std::uint64_t count = 1;
    for (const UniformValues& each : sweeps)
        if (__builtin_mul_overflow(count, std::uint64_t{each.values.size()}, &count))
            return std::numeric_limits<std::uint64_t>::max();
    return count;
}

std::vector<Combination> combinations(std::span<const UniformValues> sweeps) {
    std::vector<Combination> all{{}};
    for (const UniformValues& sweep : sweeps) {
        std::vector<Combination> longer;
        longer.reserve(all.size() * sweep.values.size());
        for (const Combination& begun : all)
            for (const UniformValue& value : sweep.values) {
                Combination next = begun;
                next.suffix += fmt::format("@{}={}", labelOf(sweep.name), value.label);
                next.set.push_back(sweep.name + "=" + value.text);
                longer.push_back(std::move(next));
            }
        all = std::move(longer);
    }
    return all;
}

namespace {

/// "uTol=0.1, time=2" for "@uTol=0.1@time=2".
std::string momentLabel(std::string_view suffix) {
    std::string label;
    for (const char each : suffix.substr(std::min<std::size_t>(suffix.size(), 1)))
        label += each == '@' ? std::string(", ") : std::string(1, each);
    return label;
}

/// The text of a --sweep as TOML has it, where a number has digits on both sides of its point and a word
/// stands in quotes: "[0.5, 1.0]" for "[.5, 1.]" and "['sky', 'room']" for "[sky, room]", which scenes and
/// --set know. What is in quotes and the name stay.
std::string asToml(std::string_view sweep) {
    const auto isDigitAt = [&](std::size_t at) {
        return at < sweep.size() && sweep[at] >= '0' && sweep[at] <= '9';
    };
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    std::string text;
    char quote = 0;
    bool isValue = false;
    for (std::size_t i = 0; i < sweep.size(); ++i) {
        const char c = sweep[i];
        if (quote != 0)
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        isValue = isValue || (c == '=' && quote == 0);
        if (isValue && quote == 0 && isLetter(c) && !isLetter(sweep[i - 1]) && !isDigitAt(i - 1) &&
            sweep[i - 1] != '.') {
            std::size_t end = i;
            while (end < sweep.size() && (isLetter(sweep[end]) || isDigitAt(end))) ++end;
            const std::string_view word = sweep.substr(i, end - i);
            const bool isTomls = word == "true" || word == "false" || word == "inf" || word == "nan";
            text += isTomls ? std::string(word) : fmt::format("'{}'", word);
            i = end - 1;
            continue;
        }
        const bool isPoint = isValue && quote == 0 && c == '.';
        const bool hasBefore = i > 0 && isDigitAt(i - 1), hasAfter = isDigitAt(i + 1);
        if (isPoint && !hasBefore && hasAfter) text += '0';
        text += c;
        if (isPoint && hasBefore && !hasAfter) text += '0';
    }
    return text;
}

}  // namespace

Diagnostic tooManyMoments(std::uint64_t count) {
    return withoutId(
        Severity::error,
        fmt::format("{} pictures of every submission are too many; the limit is {}", count, kMostMoments));
}

Result<std::vector<Moment>> momentsOf(const Shot& picture, std::span<const double> times,
                                      std::span<const std::string> sweeps) {
    std::string text;
    for (const std::string& each : sweeps) text += asToml(each) + "\n";
    TomlReader reader("--sweep", text);
    std::vector<UniformValues> values;
    if (const TomlTable* table = reader.root()) values = readUniforms(reader, *table, UniformTable::sweep);
    if (reader.hasErrors()) return reader.take();
    const std::vector<double> all =
        times.empty() ? std::vector{picture.options.time} : std::vector(times.begin(), times.end());
    if (const std::uint64_t count = combinationCount(values);
        count > kMostMoments || count * all.size() > kMostMoments)
        return tooManyMoments(count > kMostMoments ? count : count * all.size());
    std::vector<PlacedUniform> named;
    for (std::size_t i = 0; i < picture.options.set.size(); ++i) {
        const std::string& each = picture.options.set[i];
        named.push_back({std::string(base::trimmed(each.substr(0, each.find('=')))),
                         {"--set", static_cast<int>(i) + 1, 1}});
    }
    for (const UniformValues& each : values) named.push_back({each.name, each.place});
    std::vector<Moment> moments;
    for (const Combination& each : combinations(values))
        for (const double time : all) {
            Moment moment{
                momentLabel(each.suffix + (times.size() > 1 ? "@time=" + glib::numberText(time) : "")),
                picture};
            moment.shot.options.time = time;
            moment.shot.ownUniforms = named;
            moment.shot.options.set.insert(moment.shot.options.set.end(), each.set.begin(), each.set.end());
            moments.push_back(std::move(moment));
        }
    return moments;
}

Result<std::vector<Moment>> momentsOf(const Exercise& exercise, const std::filesystem::path& file,
                                      const RenderOptions& options) {
    Shot picture;
    picture.script = exercise.solution;
    picture.options = options;
    Result<std::vector<Moment>> moments = momentsOf(picture, exercise.times, exercise.sweeps);
    for (Diagnostic& each : moments.diagnostics)
        if (each.place.file == "--sweep") each.place = {file.generic_string(), 1, 1};
    if (moments)
        for (Moment& each : *moments) each.has = exercise.has;
    return moments;
}

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> kExerciseKeys{"solution", "times", "sweep", "has"};
constexpr std::array<std::string_view, 4> kShareKeys{"color", "within", "least", "most"};
constexpr double kLargestTime = 1e9;
constexpr std::uint64_t kLargestExercise = 1 << 20;

std::vector<double> timesOf(TomlReader& reader, const TomlValue& value) {
    const auto* list = value.as<TomlList>();
    std::vector<double> times;
    for (const TomlValue& each : list ? std::span(*list) : std::span(&value, 1))
        if (const auto time = reader.number(each, "times", -kLargestTime, kLargestTime))
            times.push_back(*time);
    return times;
}

std::optional<ColorShare> shareOf(TomlReader& reader, const TomlValue& value) {
    const TomlTable* table = reader.table(value, "has");
    if (!table) return std::nullopt;
    ColorShare share;
    const auto partOf = [&](const TomlEntry& entry) {
        return reader.number(entry.value, entry.key, 0, 1).value_or(0);
    };
    for (const TomlEntry& each : *table) {
        if (each.key == "color") {
            const auto* list = each.value.as<TomlList>();
            if (!list || list->size() != share.color.size())
                reader.wrongType(each.value, each.key, "three numbers, as [1, 0.5, 0]");
            else
                for (std::size_t i = 0; i < share.color.size(); ++i)
                    share.color.at(i) = reader.number((*list)[i], each.key, 0, 1).value_or(0);
        } else if (each.key == "within") {
            share.within = partOf(each);
        } else if (each.key == "least") {
            share.least = partOf(each);
        } else if (each.key == "most") {
            share.most = partOf(each);
        } else {
            reader.unknownKey(each, "in 'has'", kShareKeys);
        }
    }
    return share;
}

}  // namespace

bool isExercise(std::string_view text) {
    TomlReader reader("", text);
    const TomlTable* table = reader.root();
    return table && hasKey(*table, "solution");
}

Result<Exercise> readExerciseText(std::string_view text, const fs::path& file) {
    TomlReader reader(file.generic_string(), text);
    const TomlTable* table = reader.root();
    if (!table) return reader.take();
    Exercise exercise;
    for (const TomlEntry& each : *table) {
        if (each.key == "solution") {
            if (const std::optional<std::string> name = reader.text(each.value, "solution"))
                exercise.solution = (file.parent_path() / *name).lexically_normal();
        } else if (each.key == "times") {
            exercise.times = timesOf(reader, each.value);
        } else if (each.key == "sweep") {
            exercise.sweeps = reader.texts(each.value, "sweep").value_or(std::vector<std::string>());
        } else if (each.key == "has") {
            exercise.has = shareOf(reader, each.value);
        } else {
            reader.unknownKey(each, "in an exercise", kExerciseKeys);
        }
    }
    if (reader.hasErrors()) return reader.take();
    return exercise;
}

Result<Exercise> readExercise(const fs::path& file) {
    std::error_code failure;
    if (!fs::is_regular_file(file, failure)) return Diagnostics{};
    const auto bytes = image::readFile(file, {file.generic_string(), {}}, kLargestExercise);
    if (!bytes) return bytes.diagnostics;
    const std::string_view text = base::asText(*bytes);
    return isExercise(text) ? readExerciseText(text, file) : Diagnostics{};
}

fs::path exerciseFileOf(const fs::path& scene) {
    fs::path file = scene;
    return file.replace_extension(".toml");
}

}  // namespace glibra::suite
