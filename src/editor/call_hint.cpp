#include "editor/call_hint.h"

#include <algorithm>
#include <optional>

#include "base/text.h"
#include "editor/reference.h"

namespace glibra::editor {
namespace {

constexpr std::size_t kFarthest = 2000;  // bytes: arguments are not longer

struct OpenCall {
    TextRange name;
    std::size_t argument = 0;
};

/// The same text with blanks in place of comments that end with their line.
std::string withoutComments(std::string_view text) {
    std::string kept(text);
    for (std::size_t at = kept.find("//"); at != std::string::npos; at = kept.find("//", at)) {
        const std::size_t end = std::min(kept.find('\n', at), kept.size());
        std::fill(kept.begin() + static_cast<std::ptrdiff_t>(at),
                  kept.begin() + static_cast<std::ptrdiff_t>(end), ' ');
        at = end;
    }
    return kept;
}

/// The innermost parenthesis after a name that is open at the end of the text. `stops`: what no call reaches
/// over.
std::optional<OpenCall> openCall(std::string_view text, std::string_view stops) {
    std::size_t argument = 0;
    int depth = 0;
    const std::size_t farthest = text.size() > kFarthest ? text.size() - kFarthest : 0;
    for (std::size_t at = text.size(); at-- > farthest;) {
        const char c = text[at];
        if (stops.find(c) != std::string_view::npos) return std::nullopt;
        if (c == ')' || c == ']') ++depth;
        if (c == ',' && depth == 0) ++argument;
        if ((c != '(' && c != '[') || depth-- > 0) continue;
        depth = 0;
        std::size_t end = at;
        while (end > 0 && text[end - 1] == ' ') --end;
        const TextRange name = c == '(' ? wordBefore(text, end) : TextRange{end, end};
        if (name.begin < name.end && !base::isDigit(text[name.begin])) return OpenCall{name, argument};
        argument = 0;  // a parenthesis or subscript inside of an argument
    }
    return std::nullopt;
}

/// The argument of that number between the first parentheses: "T mix(T x, T y, T a)".
SignatureParts partsOf(const std::string& code, std::size_t argument) {
    const std::size_t open = code.find('(');
    if (open == std::string::npos) return {code, {}, {}};
    std::size_t begin = open + 1;
    for (std::size_t number = 0; begin < code.size(); ++number) {
        const std::size_t end = code.find_first_of(",)", begin);
        if (end == std::string::npos) break;
        if (number == argument) {
            while (begin < end && code[begin] == ' ') ++begin;
            return {code.substr(0, begin), code.substr(begin, end - begin), code.substr(end)};
        }
        if (code[end] == ')') break;
        begin = end + 1;
    }
    return {code, {}, {}};
}

/// Overloads stand in one text, with three blanks between them.
std::vector<std::string> overloads(const std::string& code) {
    std::vector<std::string> all;
    std::size_t begin = 0;
    for (;;) {
        const std::size_t end = code.find("   ", begin);
        all.push_back(code.substr(begin, end - begin));
        if (end == std::string::npos) return all;
        begin = code.find_first_not_of(' ', end);
        if (begin == std::string::npos) return all;
    }
}

CallHint functionHint(std::string_view text, const OpenCall& call, const CodeContext& context) {
    const ReferenceEntry entry = referenceAt(text, call.name.begin, context);
    CallHint hint;
    for (const std::string& code : entry.code)
        for (const std::string& each : overloads(code))
            if (each.find(entry.word + "(") != std::string::npos)
                hint.signatures.push_back(partsOf(each, call.argument));
    // Those that have such an argument, if any has.
    const auto lacksIt = [](const SignatureParts& each) { return each.argument.empty(); };
    if (!std::ranges::all_of(hint.signatures, lacksIt)) std::erase_if(hint.signatures, lacksIt);
    if (!hint.signatures.empty()) hint.word = entry.word;
    return hint;
}

/// The usage of the command on whose line the cursor is, after its word.
CallHint commandHint(std::string_view text, std::string_view before, const CodeContext& context) {
    const std::size_t first = before.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    const TextRange word = wordAt(before, first);
    if (word.begin != first || word.end >= before.size()) return {};
    const auto lineBegin = static_cast<std::size_t>(before.data() - text.data());
    const ReferenceEntry entry = referenceAt(text, lineBegin + first, context);
    CallHint hint;
    for (const std::string& each : entry.code)
        if (each != entry.word) hint.signatures.push_back({each, {}, {}});
    if (!hint.signatures.empty()) hint.word = entry.word;
    return hint;
}

}  // namespace

CallHint callAt(std::string_view text, std::size_t cursor, const CodeContext& context) {
    cursor = std::min(cursor, text.size());
    const LanguageAt at = languageAt(text, cursor, context);
    const std::string_view line = lineBefore(text, cursor);
    if (at.language == CodeLanguage::glsl) {
        if (line.find("//") != std::string_view::npos) return {};
        const std::string before = withoutComments(text.substr(0, cursor));
        const std::optional<OpenCall> call = openCall(before, ";{}");
        return call ? functionHint(text, *call, context) : CallHint();
    }
    if (line.find('#') != std::string_view::npos) return {};
    const std::string_view statement = statementBefore(text, cursor);
    if (const std::optional<OpenCall> call = openCall(statement, "")) {
        const std::size_t begin = cursor - statement.size();
        const TextRange name{call->name.begin + begin, call->name.end + begin};
        if (CallHint hint = functionHint(text, {name, call->argument}, context); !hint.word.empty())
            return hint;
    }
    return commandHint(text, statement, context);
}

}  // namespace glibra::editor
