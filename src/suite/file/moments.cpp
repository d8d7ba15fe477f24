#include "suite/file/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "glib/number.h"
#include "suite/file/sweep.h"
#include "suite/file/toml_reader.h"

namespace glibra::suite {
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

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
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
        named.push_back({trimmed(each.substr(0, each.find('='))), {"--set", static_cast<int>(i) + 1, 1}});
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
        if (each.place.file == "--sweep") each.place = {file.string(), 1, 1};
    if (moments)
        for (Moment& each : *moments) each.has = exercise.has;
    return moments;
}

}  // namespace glibra::suite
