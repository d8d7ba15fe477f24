#include "glsl/emit/log_line.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <limits>

#include "base/text.h"
#include "glsl/read/token.h"

namespace glibra::glsl {
namespace {

bool startsWithNoCase(std::string_view text, std::string_view prefix) {
    if (text.size() < prefix.size()) return false;
    return std::equal(prefix.begin(), prefix.end(), text.begin(), [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    });
}

bool takeNoCase(std::string_view& text, std::string_view prefix) {
    if (!startsWithNoCase(text, prefix)) return false;
    text.remove_prefix(prefix.size());
    return true;
}

void skipBlanks(std::string_view& text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
}

bool takeNumber(std::string_view& text, int& value) {
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end == text.data() || value < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

/// Takes the source from the front: a quoted or known file name, a number, or the word before `stop` and a
/// number.
bool takeSource(std::string_view& text, std::span<const std::string> files, char stop, std::string& source) {
    if (text.starts_with("\"")) {
        const std::size_t end = text.find('"', 1);
        if (end == std::string_view::npos) return false;
        source = text.substr(1, end - 1);
        text.remove_prefix(end + 1);
        return text.starts_with(stop);
    }
    for (const std::string& each : files)
        if (!each.empty() && text.size() > each.size() && text.starts_with(each) &&
            text[each.size()] == stop) {
            source = each;
            text.remove_prefix(each.size());
            return true;
        }
    for (std::size_t at = text.find(stop); at != std::string_view::npos; at = text.find(stop, at + 1)) {
        if (at + 1 >= text.size() || text[at + 1] < '0' || text[at + 1] > '9' || at == 0) continue;
        // Messages contain such text too. Only the name of a known file may contain blanks.
        if (text.substr(0, at).find(' ') != std::string_view::npos) return false;
        source = text.substr(0, at);
        text.remove_prefix(at);
        return true;
    }
    return false;
}

/// Takes "error", "preprocessor error", "warning" ... from the front; false if there is none.
bool takeSeverity(std::string_view& text, bool& isWarning) {
    takeNoCase(text, "preprocessor ");
    takeNoCase(text, "fatal ");
    isWarning = startsWithNoCase(text, "warning");
    return takeNoCase(text, "error") || takeNoCase(text, "warning");
}

/// Takes " C1008: " or "(#143) " after the severity from the front.
void dropCode(std::string_view& text) {
    skipBlanks(text);
    std::size_t end = 0;
    if (text.starts_with("(#")) {
        end = text.find(')');
        if (end != std::string_view::npos) text.remove_prefix(end + 1);
    } else if (!text.empty() && text.front() == 'C') {
        end = 1;
        while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
        if (end > 3 && end < text.size() && text[end] == ':') text.remove_prefix(end);
    }
    if (text.starts_with(":")) text.remove_prefix(1);
    skipBlanks(text);
}

/// Takes the "#error " that drivers repeat from the shader: the severity says it already.
void dropDirective(std::string_view& text) {
    if (text.size() > 7 && takeNoCase(text, "#error ")) skipBlanks(text);
}

/// Reads "ERROR: 0:12: text".
std::optional<LogLine> parsePrefixed(std::string_view text, std::span<const std::string> files) {
    LogLine line;
    line.isWarning = startsWithNoCase(text, "warning:");
    if (!takeNoCase(text, "error:") && !takeNoCase(text, "warning:")) return std::nullopt;
    skipBlanks(text);
    if (!takeSource(text, files, ':', line.source)) return std::nullopt;
    text.remove_prefix(1);
    if (!takeNumber(text, line.line)) return std::nullopt;
    if (takeNoCase(text, "(") && (!takeNumber(text, line.column) || !takeNoCase(text, ")")))
        return std::nullopt;
    if (!takeNoCase(text, ":")) return std::nullopt;
    skipBlanks(text);
    bool again = false;
    std::string_view rest = text;
    if (startsWithNoCase(rest, "error(#") || startsWithNoCase(rest, "warning(#")) {
        takeSeverity(rest, again);
        dropCode(rest);
        text = rest;
    }
    dropDirective(text);
    line.text = text;
    return line;
}

/// Reads "0:12(5): error: text".
std::optional<LogLine> parseMesa(std::string_view text, std::span<const std::string> files) {
    LogLine line;
    line.collapsed = true;
    if (!takeSource(text, files, ':', line.source)) return std::nullopt;
    text.remove_prefix(1);
    if (!takeNumber(text, line.line) || !takeNoCase(text, "(") || !takeNumber(text, line.column) ||
        !takeNoCase(text, "):"))
        return std::nullopt;
    skipBlanks(text);
    if (!takeSeverity(text, line.isWarning)) return std::nullopt;
    dropCode(text);
    dropDirective(text);
    line.text = text;
    return line;
}

/// Reads "0(12) : error C1008: text".
std::optional<LogLine> parseNvidia(std::string_view text, std::span<const std::string> files) {
    LogLine line;
    if (!takeSource(text, files, '(', line.source)) return std::nullopt;
    text.remove_prefix(1);
    if (!takeNumber(text, line.line) || !takeNoCase(text, ")")) return std::nullopt;
    skipBlanks(text);
    if (!takeNoCase(text, ":")) return std::nullopt;
    skipBlanks(text);
    if (!takeSeverity(text, line.isWarning)) return std::nullopt;
    dropCode(text);
    dropDirective(text);
    line.text = text;
    return line;
}

/// The column in `text` for the `column` of a preprocessor that counts a run of blanks and comments as one
/// blank.
int expandColumn(std::string_view text, int column) {
    int counted = 0;
    std::size_t i = 0;
    while (i < text.size()) {
        std::size_t end = i;
        while (end < text.size()) {
            if (text[end] == ' ' || text[end] == '\t') {
                ++end;
            } else if (text.substr(end, 2) == "/*") {
                const std::size_t close = text.find("*/", end + 2);
                end = close == std::string_view::npos ? text.size() : close + 2;
            } else {
                break;
            }
        }
        if (end == i) ++end;
        if (++counted >= column) break;
        i = end;
    }
    return static_cast<int>(std::min(i, text.size())) + 1;
}

/// The column of the `word` that is nearest to `column`; `column` if there is none.
int nearestWord(std::string_view text, std::string_view word, int column) {
    int best = column;
    int distance = std::numeric_limits<int>::max();
    if (word.empty()) return column;
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const bool whole = (at == 0 || !base::isOfName(text[at - 1])) &&
                           (at + word.size() >= text.size() || !base::isOfName(text[at + word.size()]));
        const int here = static_cast<int>(at) + 1;
        if (whole && std::abs(here - column) < distance) {
            distance = std::abs(here - column);
            best = here;
        }
    }
    return best;
}

}  // namespace

std::string_view lineOfText(std::string_view text, std::size_t number) {
    for (; number > 0; --number) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    return text.substr(0, std::min(text.find('\n'), text.size()));
}

std::optional<LogLine> parseLogLine(std::string_view line, std::span<const std::string> files) {
    if (line.size() > 20'000) return std::nullopt;
    if (auto found = parsePrefixed(line, files)) return found;
    if (auto found = parseMesa(line, files)) return found;
    return parseNvidia(line, files);
}

bool isLogSummary(std::string_view line) {
    if (line.find_first_not_of("-= ") == std::string_view::npos) return true;
    static constexpr std::array<std::string_view, 5> kPhrases = {
        "compilation errors.", "No code generated", "compilation terminated",
        "failed to compile with the following", "was successfully compiled"};
    return std::ranges::any_of(
        kPhrases, [&](std::string_view each) { return line.find(each) != std::string_view::npos; });
}

const TranslatedStage* stageOfHeading(const TranslatedProgram& program, std::string_view line) {
    static constexpr std::array<std::string_view, kStageCount> kHeadings = {"Vertex info",
                                                                            "Tessellation control info",
                                                                            "Tessellation evaluation info",
                                                                            "Geometry info",
                                                                            "Fragment info",
                                                                            "Compute info"};
    for (std::size_t i = 0; i < kHeadings.size(); ++i) {
        if (!line.starts_with(kHeadings[i])) continue;
        for (const TranslatedStage& each : program.stages)
            if (each.stage == static_cast<Stage>(i)) return &each;
    }
    return nullptr;
}

bool stripSeverity(std::string_view& text) {
    std::string_view rest = text;
    bool isWarning = false;
    if (takeSeverity(rest, isWarning) &&
        (rest.starts_with(":") || rest.starts_with(" C") || rest.starts_with("(#"))) {
        dropCode(rest);
        text = rest;
        return isWarning;
    }
    return false;
}

std::string_view quotedWord(std::string_view text) {
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        if (text[i] != '`' && text[i] != '\'' && text[i] != '"') continue;
        std::size_t end = i + 1;
        while (end < text.size() && base::isOfName(text[end])) ++end;
        if (end > i + 1 && end < text.size() && (text[end] == '\'' || text[end] == '"'))
            return text.substr(i + 1, end - i - 1);
        i = end;
    }
    return {};
}

std::optional<EmittedPlace> emittedPlace(const TranslatedStage& stage, const LogLine& line,
                                         const std::string& file) {
    const LineMap& map = stage.lineMap;
    std::optional<EmittedPlace> blank;  // a text in a scene stands after as many lines as there
    for (std::size_t i = 0; i < map.lines.size(); ++i) {
        if (map.lines[i].file < 0 || map.lines[i].line != line.line ||
            map.files[static_cast<std::size_t>(map.lines[i].file)] != file)
            continue;
        const std::string_view text = lineOfText(stage.source, i);
        const int column = line.collapsed ? expandColumn(text, line.column) : line.column;
        const EmittedPlace place{i, line.column <= 0 ? 0 : nearestWord(text, quotedWord(line.text), column)};
        if (!text.empty()) return place;
        if (!blank) blank = place;
    }
    return blank;
}

UserPlace userPlace(const TranslatedStage& stage, const EmittedPlace& place) {
    const LineMap& map = stage.lineMap;
    UserPlace user{map.lines[place.line]};
    if (place.column <= 0) return user;
    ColumnShift shift{1, 1, user.line};
    int next = std::numeric_limits<int>::max();
    if (place.line < map.columns.size())
        for (const ColumnShift& each : map.columns[place.line]) {
            if (each.emitted > place.column) {
                if (each.line.line == shift.line.line && each.macro < 0) next = each.user;
                break;
            }
            shift = each;
        }
    user.line = shift.line;
    if (shift.macro >= 0) {
        user.macro = &map.macros[static_cast<std::size_t>(shift.macro)];
        user.column = shift.user;
        return user;
    }
    // Inside a longer spelling of the translator, the column is that of the user's word.
    user.column =
        std::max(1, std::min(shift.user + place.column - shift.emitted, std::max(shift.user, next - 1)));
    return user;
}

// ---- What a message is about

namespace {

/// The text around an undeclared name. The name ends where its letters and digits end.
struct NamePhrase {
    std::string_view before;  ///< up to the name
    std::string_view after;   ///< right after it
};
constexpr std::array kUndeclaredPhrases = std::to_array<NamePhrase>({
    {"`", "' undeclared"},                         // Mesa
    {"no function with name '", "'"},              // Mesa
    {"undefined variable \"", "\""},               // NVIDIA
    {"'", "' : undeclared identifier"},            // glslang, Intel, AMD, Apple, ANGLE
    {"'", "' : no matching overloaded function"},  // the same, also for functions that nobody declares
    {"undeclared identifier '", "'"},              // Apple
    {"Undeclared identifier: ", ""},               // AMD (fglrx)
    {"Undeclared identifier '", "'"},              // Intel
    {"'", "' is not declared"},                    // Qualcomm
    {"No matching function for call to '", "'"},   // Apple, of names that are no function either
});

constexpr std::array kTypePhrases = std::to_array<std::string_view>({
    "mismatch",                      // Mesa: "type mismatch", "parameter type mismatch"
    "could not implicitly convert",  // Mesa
    "must have the same type",       // Mesa
    "cannot be assigned to",         // Mesa: "initializer of type vec3 cannot be assigned to ..."
    "incompatible types",            // NVIDIA: C1060, C1035
    "invalid operands to",           // NVIDIA: C1020
    "implicit cast from",            // NVIDIA: C7011
    "wrong operand",                 // glslang, Intel, AMD, Apple
    "no operation",                  // the same
    "cannot convert",                // the same
});

constexpr std::array kConsequencePhrases = std::to_array<std::string_view>({
    "from a non-numeric data type",                      // Mesa
    "operands to arithmetic operators must be numeric",  // Mesa
    "used uninitialized",                                // Mesa
    "(error,", "(error)", ", error,", ", error)",        // Mesa: candidates of a call with such an argument
    "compilation terminated",                            // glslang
});

constexpr std::array kSyntaxPhrases = std::to_array<std::string_view>({
    "syntax error",      // Mesa, NVIDIA, glslang, AMD, Intel
    "Syntax error",      // ANGLE, Apple
    "unexpected token",  // Apple
});

bool containsAny(std::string_view text, std::span<const std::string_view> phrases) {
    return std::ranges::any_of(
        phrases, [&](std::string_view each) { return text.find(each) != std::string_view::npos; });
}

std::string_view nameIn(std::string_view message, const NamePhrase& phrase) {
    for (std::size_t at = message.find(phrase.before); at != std::string_view::npos;
         at = message.find(phrase.before, at + 1)) {
        const std::size_t first = at + phrase.before.size();
        std::size_t end = first;
        while (end < message.size() && base::isOfName(message[end])) ++end;
        if (end > first && message.substr(end).starts_with(phrase.after))
            return message.substr(first, end - first);
    }
    return {};
}

}  // namespace

std::string_view undeclaredName(std::string_view message) {
    for (const NamePhrase& each : kUndeclaredPhrases)
        if (const std::string_view name = nameIn(message, each); !name.empty()) return name;
    return {};
}

bool isAboutTypes(std::string_view message) {
    return containsAny(message, kTypePhrases);
}

bool isConsequence(std::string_view message) {
    return containsAny(message, kConsequencePhrases);
}

bool isSyntaxError(std::string_view message) {
    return containsAny(message, kSyntaxPhrases);
}

}  // namespace glibra::glsl
