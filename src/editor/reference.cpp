#include "editor/reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "base/suggest.h"
#include "base/text.h"
#include "editor/declared_names.h"
#include "editor/glsl_reference.h"
#include "editor/scene_places.h"
#include "expression/functions.h"
#include "expression/known_names.h"
#include "glib/syntax.h"
#include "glsl/read/words.h"
#include "scene/shader_names.h"

namespace glibra::editor {
namespace {

/// "Sphere radius = 1, slices = 60, stacks = 60".
std::string usageOf(const glib::StatementRow& row) {
    std::string text(row.name);
    for (const glib::SyntaxNode* each : glib::argumentsOf(row)) {
        text += each == glib::argumentsOf(row).front() ? " " : ", ";
        const bool mayMiss = each->isSkippable || each->byDefault || each->filler;
        text += mayMiss ? "[" + each->text : each->text;
        if (each->byDefault || each->filler)
            text += fmt::format(" = {:g}", each->byDefault ? *each->byDefault : *each->filler);
        if (mayMiss) text += "]";
        if (!each->measure.empty()) text += fmt::format(" ({})", each->measure);
        if (!each->words.empty()) text += fmt::format(" {}", fmt::join(each->words, " | "));
    }
    return text;
}

void addTo(ReferenceEntry& entry, std::string_view sentence) {
    if (sentence.empty()) return;
    if (!entry.text.empty()) entry.text += "\n";
    entry.text += sentence;
}

ReferenceEntry commandEntry(std::string_view word) {
    ReferenceEntry entry;
    const glib::StatementRow* command = glib::findCommand(word);
    const glib::StatementRow* statement = command ? glib::modernFormOf(word) : glib::findStatement(word);
    if (command) {
        entry.word = command->name;
        entry.code.push_back(usageOf(*command));
        addTo(entry, command->summary);
        entry.chapter = "docs/language.md, section 3";
    }
    if (statement) {
        entry.word = statement->name;
        entry.code.push_back(glib::usage(*statement));
        for (const glib::WordList& each : glib::wordLists(*statement))
            entry.code.push_back(fmt::format("{}: {}", each.name, fmt::join(each.words, " ")));
        addTo(entry, statement->summary);
        entry.chapter = "docs/language.md, section 12";
    }
    return entry;
}

/// What expressions know by that name.
ReferenceEntry nameEntry(std::string_view word) {
    ReferenceEntry entry;
    for (const expression::FunctionRow& each : expression::functionsNamed(word)) {
        entry.word = word;
        entry.code.emplace_back(each.prototype);
        addTo(entry, each.summary);
        entry.chapter = "docs/language.md, section 1.8";
    }
    for (const expression::NameRow& each : expression::sceneNames())
        if (each.path == word) {
            entry.word = word;
            entry.code.push_back(fmt::format("{} {}", expression::name(each.type), each.path));
            addTo(entry, each.summary);
            entry.chapter = "docs/language.md, section 1.8";
        }
    if (!entry.word.empty()) return entry;
    for (const expression::PartRow& each : expression::partTable())
        if (each.word == word) {
            entry.word = word;
            entry.code.emplace_back(each.form);
            addTo(entry, each.summary);
            entry.chapter = "docs/language.md, section 12";
        }
    return entry;
}

ReferenceEntry glslEntry(std::string_view word) {
    ReferenceEntry entry;
    for (const scene::ShaderName& each : scene::shaderNames()) {
        if (std::ranges::find(each.names, word) == each.names.end()) continue;
        entry.word = word;
        entry.code.push_back(fmt::format("{} {} {}", each.isInput ? "in" : "uniform", each.type, word));
        addTo(entry, each.meaning + "; glibra supplies it, it needs no declaration");
        entry.chapter = "docs/language.md, section 6";
    }
    if (!entry.word.empty()) return entry;
    if (const GlslRow* row = findGlsl(word)) {
        entry.word = word;
        entry.code.emplace_back(row->signature);
        entry.text = row->summary;
        entry.chapter = fmt::format("GLSL, from version {}", row->since);
        if (row->until < 1000) entry.chapter += fmt::format(" to before {}", row->until);
    } else if (const int since = glsl::keywordSince(word); since > 0 && since != glsl::kReserved) {
        entry.word = word;
        entry.text = glsl::isTypeWord(word) ? "a type of GLSL" : "a keyword of GLSL";
        entry.chapter = fmt::format("GLSL, from version {}", since);
    }
    return entry;
}

std::string nearest(std::string_view word, CodeLanguage language) {
    std::vector<std::string_view> known;
    const std::vector<scene::ShaderName> names = scene::shaderNames();
    if (language == CodeLanguage::glsl) {
        for (const GlslRow& each : glslTable()) known.push_back(each.name);
        for (const scene::ShaderName& each : names)
            known.insert(known.end(), each.names.begin(), each.names.end());
    } else if (const std::string_view command = glib::nearestCommand(word); !command.empty()) {
        known.push_back(command);
    }
    return base::suggestion(word, known);
}

}  // namespace

ReferenceEntry referenceOf(std::string_view word, CodeLanguage language, const CodeContext& context,
                           bool isArgument) {
    const bool isGlib = language == CodeLanguage::glib;
    ReferenceEntry entry = !isGlib ? glslEntry(word) : isArgument ? ReferenceEntry() : commandEntry(word);
    for (const KnownName& each : context.names) {
        if (each.name != word || each.in != language) continue;
        if (entry.word.empty()) {
            entry.word = each.name;
            const bool isFunction = each.type.find('(') != std::string::npos;
            entry.code.push_back(isFunction ? each.type : fmt::format("{} {}", each.type, each.name));
            entry.text = each.what;
        }
        if (entry.value.empty()) entry.value = each.value;
    }
    if (isGlib && entry.word.empty()) entry = nameEntry(word);
    if (entry.word.empty() && !word.empty())
        entry.text = fmt::format("there is no entry for '{}'{}", word, nearest(word, language));
    return entry;
}

ReferenceEntry referenceAt(std::string_view text, std::size_t byte, const CodeContext& context) {
    const TextRange range = wordAt(text, byte);
    const std::string_view word = text.substr(range.begin, range.end - range.begin);
    const LanguageAt at = languageAt(text, byte, context);
    const bool isArgument = !base::trimmed(statementBefore(text, range.begin)).empty();
    ReferenceEntry entry = referenceOf(word, at.language, context, isArgument);
    for (const Declaration& each : declarationsOf(isArgument && entry.word.empty() ? text : ""))
        if (at.language == CodeLanguage::glib && each.name == word) {
            entry.word = word;
            entry.code = {std::string(text.substr(each.whole.begin, each.whole.end - each.whole.begin))};
            entry.text.clear();
        }
    if (at.language == CodeLanguage::glib || word.empty()) return entry;
    const std::string_view part = text.substr(at.part.begin, at.part.end - at.part.begin);
    const auto firstLine =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at.part.begin), '\n');
    const ShaderNames names = namesOfShader(part);
    const NameUse* use = names.useAt(range.begin - at.part.begin);
    if (use == nullptr || use->target == kNoName) return entry;
    const DeclaredName& declared = names.names[use->target];
    entry.word = word;
    entry.code = {declared.declaration};
    entry.text = fmt::format("declared in line {}", declared.line + firstLine);
    entry.chapter.clear();
    return entry;
}

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
        const std::size_t end = std::min(kept.find_first_of("\r\n", at), kept.size());
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
    if (line.find('#') != line.npos || line.find("//") != line.npos) return {};
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
