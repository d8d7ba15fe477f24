#include "glsl/read/version.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace glibra::glsl {
namespace {

constexpr std::array kKnown = {110, 120, 130, 140, 150, 330, 400, 410, 420, 430, 440, 450, 460};
constexpr int kHighest = 460;

std::string joined(std::span<const std::string_view> words) {
    std::string text = "#version";
    for (const std::string_view each : words) text += " " + std::string(each);
    return text;
}

/// The whole number at the start of `text`, -1 if there is none; `rest` is the text after it.
int leadingNumber(std::string_view text, std::string_view& rest) {
    int value = -1;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{}) {
        rest = text;
        return failure == std::errc::result_out_of_range ? 1'000'000 : -1;
    }
    rest = text.substr(static_cast<std::size_t>(end - text.data()));
    return value;
}

}  // namespace

Dialect readVersion(std::span<const std::string_view> words, const Place& place, int targetVersion,
                    Report& report) {
    Dialect dialect;
    dialect.given = true;
    dialect.place = place;
    std::string_view rest;
    int number = words.empty() ? -1 : leadingNumber(words[0], rest);
    bool tolerated = false;
    if (rest.starts_with(".") && number >= 1 && number < 10) {
        std::string_view after;
        int minor = leadingNumber(rest.substr(1), after);
        if (minor >= 0 && rest.size() == 2) minor *= 10;
        number = number * 100 + std::max(minor, 0);
        rest = after;
        tolerated = true;
    }
    if (number < 0 || !rest.empty()) tolerated = true;
    if (number < 0) number = 330;

    const std::string_view profile = words.size() > 1 ? words[1] : std::string_view{};
    if (profile == "es" || number == 100) {
        dialect.version = number <= 100 ? 120 : (number < 310 ? 330 : (number < 320 ? 430 : 450));
        dialect.written = number;
        dialect.es = true;
        report.report("glsl-W03", "'" + joined(words) + "' treated as " + std::to_string(dialect.version),
                      place);
        return dialect;
    }
    if (number > kHighest) {
        report.report("glsl-E07",
                      "#version " + std::to_string(number) + " is not supported, 460 is the highest", place);
        return dialect;
    }
    const auto* const above = std::upper_bound(kKnown.begin(), kKnown.end(), number);
    dialect.version = above == kKnown.begin() ? kKnown.front() : *(above - 1);
    dialect.written = number;
    dialect.core = profile == "core";
    if (profile == "core" || profile == "compatibility")
        dialect.profile = profile;
    else if (!profile.empty())
        tolerated = true;
    if (words.size() > 2 || dialect.version != number) tolerated = true;
    if (tolerated) {
        std::string reading = std::to_string(dialect.version);
        if (!dialect.profile.empty()) reading += " " + dialect.profile;
        report.report("glsl-W02", "'" + joined(words) + "' read as " + reading, place);
    }
    if (dialect.version == kHighest && targetVersion < kHighest)
        report.report("glsl-W18", "#version 460 compiled as " + std::to_string(targetVersion), place);
    return dialect;
}

}  // namespace glibra::glsl
