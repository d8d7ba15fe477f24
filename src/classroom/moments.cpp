#include "classroom/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "glib/number.h"
#include "suite/file/exercise_file.h"
#include "suite/file/suite_file.h"
#include "suite/file/sweep.h"
#include "suite/file/toml_reader.h"

namespace glibra::classroom {
namespace {

/// "uTol=0.1, time=2" for "@uTol=0.1@time=2".
std::string labelOf(std::string_view suffix) {
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

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Diagnostic tooMany(std::uint64_t count) {
    return withoutId(
        Severity::error,
        fmt::format("{} pictures of every submission are too many; the limit is {}", count, kMostMoments));
}

}  // namespace

Result<std::vector<Moment>> momentsOf(const suite::Shot& picture, std::span<const double> times,
                                      std::span<const std::string> sweeps) {
    std::string text;
    for (const std::string& each : sweeps) text += asToml(each) + "\n";
    suite::TomlReader reader("--sweep", text);
    std::vector<suite::UniformValues> values;
    if (const suite::TomlTable* table = reader.root())
        values = suite::readUniforms(reader, *table, suite::UniformTable::sweep);
    if (reader.hasErrors()) return reader.take();
    const std::vector<double> all =
        times.empty() ? std::vector{picture.options.time} : std::vector(times.begin(), times.end());
    if (const std::uint64_t count = suite::combinationCount(values);
        count > kMostMoments || count * all.size() > kMostMoments)
        return tooMany(count > kMostMoments ? count : count * all.size());
    std::vector<suite::PlacedUniform> named;
    for (std::size_t i = 0; i < picture.options.set.size(); ++i) {
        const std::string& each = picture.options.set[i];
        named.push_back({trimmed(each.substr(0, each.find('='))), {"--set", static_cast<int>(i) + 1, 1}});
    }
    for (const suite::UniformValues& each : values) named.push_back({each.name, each.place});
    std::vector<Moment> moments;
    for (const suite::Combination& each : suite::combinations(values))
        for (const double time : all) {
            Moment moment{labelOf(each.suffix + (times.size() > 1 ? "@time=" + glib::numberText(time) : "")),
                          picture};
            moment.shot.options.time = time;
            moment.shot.ownUniforms = named;
            moment.shot.options.set.insert(moment.shot.options.set.end(), each.set.begin(), each.set.end());
            moments.push_back(std::move(moment));
        }
    return moments;
}

std::vector<Slider> slidersOf(std::span<const Moment> moments) {
    const auto valuesOf = [](const Moment& moment) {
        std::map<std::string, std::string> values;
        for (const std::string& each : moment.shot.options.set) {
            const std::size_t equals = std::min(each.find('='), each.size());
            values[trimmed(each.substr(0, equals))] = each.substr(equals);
        }
        values["time"] = glib::numberText(moment.shot.options.time);
        return values;
    };
    const auto onlyDifference = [&](const Moment& a, const Moment& b) -> std::string {
        std::vector<std::pair<std::string, std::string>> different;  // sorted by names
        std::ranges::set_symmetric_difference(valuesOf(a), valuesOf(b), std::back_inserter(different));
        const bool isOne = !different.empty() && different.front().first == different.back().first;
        return isOne ? different.front().first : "";
    };
    std::vector<Slider> sliders;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        std::set<std::string> seen;
        for (std::size_t k = i + 1; k < moments.size(); ++k) {
            const std::string name = onlyDifference(moments[i], moments[k]);
            if (name.empty() || !seen.insert(name).second) continue;
            auto known = std::ranges::find(sliders, name, &Slider::name);
            if (known == sliders.end()) known = sliders.insert(sliders.end(), {name, {}});
            if (known->pairs.size() < kMostPairs) known->pairs.emplace_back(i, k);
        }
    }
    return sliders;
}

Result<std::vector<Moment>> momentsOfSuite(const std::filesystem::path& file) {
    const Result<suite::Exercise> exercise = suite::readExercise(file);
    if (hasError(exercise.diagnostics)) return exercise.diagnostics;
    if (exercise) {
        suite::Shot picture;
        picture.script = exercise->solution;
        Result<std::vector<Moment>> moments = momentsOf(picture, exercise->times, exercise->sweeps);
        for (Diagnostic& each : moments.diagnostics)
            if (each.place.file == "--sweep") each.place = {file.string(), 1, 1};
        return moments;
    }
    Result<suite::Suite> read = suite::readSuite(file);
    if (!read) return std::move(read.diagnostics);
    if (read->shots.size() > kMostMoments) return tooMany(read->shots.size());
    std::vector<Moment> moments;
    for (const suite::Shot& shot : read->shots) {
        if (shot.script != read->shots.front().script)
            return withoutId(Severity::error,
                             fmt::format("the suite of a reference has one scene, found '{}' and '{}'",
                                         read->shots.front().script.string(), shot.script.string()),
                             shot.place);
        Moment moment{read->shots.size() > 1 ? shot.name : "", {}};
        moment.shot.script = shot.script;
        moment.shot.options = shot.options;
        moment.shot.ownUniforms = shot.ownUniforms;
        moment.shot.options.floatPixels = false;  // a browser shows no such pictures
        moment.shot.memory = shot.memory;
        moments.push_back(std::move(moment));
    }
    if (moments.empty()) return withoutId(Severity::error, "the suite has no shots", {file.string(), 1, 1});
    return {std::move(moments), std::move(read.diagnostics)};
}

}  // namespace glibra::classroom
