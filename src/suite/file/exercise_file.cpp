#include "suite/file/exercise_file.h"

#include <array>
#include <optional>
#include <span>
#include <system_error>

#include "base/files.h"
#include "image/file.h"
#include "suite/file/toml_reader.h"

namespace glibra::suite {
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
