#include "plan/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/text.h"
#include "glib/number.h"
#include "glib/text.h"
#include "plan/uniform_names.h"

namespace glibra::plan {
namespace {

constexpr std::size_t kMostValues = 4096;  // as in a bracket of the language

/// Adds the numbers, which blanks or single commas separate. Returns what is wrong; nothing if all is right.
std::string readNumbers(std::string_view text, std::vector<double>& values) {
    while (!text.empty()) {
        const std::string_view token = text.substr(0, text.find_first_of(" \t,"));
        const auto number = glib::numberPrefix(token);
        if (token.empty()) return "a number is missing beside ','";
        if (!number || number->length < token.size()) return fmt::format("'{}' is not a number", token);
        if (!number->finite) return fmt::format("'{}' is too large for a 32-bit float", token);
        if (values.size() == kMostValues) return fmt::format("more than {} values", kMostValues);
        values.push_back(number->value);
        text = base::trimmed(text.substr(token.size()));
        if (!text.starts_with(',')) continue;
        text = base::trimmed(text.substr(1));
        if (text.empty()) return "a number is missing after the last ','";
    }
    return values.empty() ? "the value is missing" : "";
}

/// True for a word that may be one of a choice. Spellings of what is not finite are none.
bool isChoiceWord(std::string_view text) {
    if (text.empty() || !glib::beginsName(text[0])) return false;
    const bool isWord = std::ranges::all_of(text, glib::isOfName);
    return isWord && !glib::sameWord(text, "nan") && !glib::sameWord(text, "inf") &&
           !glib::sameWord(text, "infinity");
}

/// Removes the brackets. Returns nothing if the closing one is missing.
std::optional<glib::UniformForm> takeBrackets(std::string_view& value) {
    struct Bracket {
        char open, close;
        glib::UniformForm form;
    };
    constexpr Bracket kBrackets[] = {{'[', ']', glib::UniformForm::list},
                                     {'(', ')', glib::UniformForm::list},
                                     {'<', '>', glib::UniformForm::range},
                                     {'{', '}', glib::UniformForm::color}};
    for (const Bracket& each : kBrackets) {
        if (!value.starts_with(each.open)) continue;
        if (value.size() < 2 || !value.ends_with(each.close)) return {};
        value = base::trimmed(value.substr(1, value.size() - 2));
        return each.form;
    }
    return glib::UniformForm::number;
}

Diagnostic notAFunction(std::string_view program, std::string_view name, std::string_view word) {
    return withoutId(
        Severity::error,
        fmt::format("--set {0}:{1}={2}: '{2}' is not a number, and program {3} has no subroutine "
                    "uniform '{1}'",
                    program, name, word, glib::inQuotes(program)));
}

}  // namespace

Result<Override> parseOverride(std::string_view text) {
    const auto bad = [&](std::string_view why) {
        return withoutId(Severity::error, fmt::format("--set {}: {}", text, why));
    };
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return bad("expected NAME=VALUE");
    Override result;
    result.name = base::trimmed(text.substr(0, equals));
    if (const std::size_t colon = result.name.rfind(':'); colon != std::string::npos) {
        result.program = base::trimmed(std::string_view(result.name).substr(0, colon));
        result.name = base::trimmed(std::string(result.name.substr(colon + 1)));
    }
    if (result.name.empty()) return bad("the name is missing");

    std::string_view value = base::trimmed(text.substr(equals + 1));
    result.written = value;
    const std::optional<glib::UniformForm> form = takeBrackets(value);
    if (!form) return bad("a bracket is not closed");
    result.form = *form;
    if (value == "true" || value == "false") {
        result.form = glib::UniformForm::truth;
        result.values = {value == "true" ? 1.0 : 0.0};
        return result;
    }
    if (result.form == glib::UniformForm::number && isChoiceWord(value)) {
        result.word = value;
        return result;
    }
    if (const std::string problem = readNumbers(value, result.values); !problem.empty()) return bad(problem);
    if (result.form == glib::UniformForm::number && result.values.size() > 1)
        result.form = glib::UniformForm::list;
    return result;
}

Diagnostic notAChoice(std::string_view name, std::string_view word) {
    return withoutId(Severity::error,
                     fmt::format("--set {0}={1}: '{1}' is not a number, and the scene has no "
                                 "choice '{0}' with words",
                                 name, word));
}

bool isFor(const Override& override, const scene::Program& program) {
    return override.program.empty() || override.program == program.name ||
           override.program == std::to_string(program.place.line);
}

Diagnostics unusedOverrides(std::span<const Override> overrides, const std::vector<bool>& used,
                            std::span<const std::string> names) {
    Diagnostics diagnostics;
    for (std::size_t i = 0; i < overrides.size(); ++i) {
        if (i < used.size() && used[i]) continue;
        const auto& [name, form, values, program, written, word] = overrides[i];
        if (!word.empty()) {
            diagnostics.push_back(program.empty() ? notAChoice(name, word)
                                                  : notAFunction(program, name, word));
            continue;
        }
        const std::string where =
            program.empty() ? "program of the scene" : "program " + glib::inQuotes(program);
        const bool isElsewhere = std::ranges::find(names, name) != names.end();
        const std::string near = isElsewhere ? "" : nearestUniform(name, names);
        diagnostics.push_back(about(diagnose("glib-W23", fmt::format("no {} has a uniform {}{}", where,
                                                                     glib::inQuotes(name), hintOf(near))),
                                    name, near));
    }
    return diagnostics;
}

Diagnostic misfit(std::string_view name, std::span<const double> values, std::size_t components) {
    std::string text;
    for (const double each : values) text += (text.empty() ? "" : ",") + glib::numberText(each);
    return diagnose("glib-W15", fmt::format("--set {0}={1}: {2}; '{0}' takes {3}, so it keeps its own", name,
                                            text, base::counted(values.size(), "value"), components));
}

}  // namespace glibra::plan
