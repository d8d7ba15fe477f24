#include "editor/reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/suggest.h"
#include "editor/declared_names.h"
#include "editor/glsl_reference.h"
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

ReferenceEntry glibEntry(std::string_view word) {
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
    if (!entry.word.empty()) return entry;
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

ReferenceEntry referenceOf(std::string_view word, CodeLanguage language, const CodeContext& context) {
    ReferenceEntry entry = language == CodeLanguage::glib ? glibEntry(word) : glslEntry(word);
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
    if (entry.word.empty() && !word.empty())
        entry.text = fmt::format("there is no entry for '{}'{}", word, nearest(word, language));
    return entry;
}

ReferenceEntry referenceAt(std::string_view text, std::size_t byte, const CodeContext& context) {
    const TextRange range = wordAt(text, byte);
    const std::string_view word = text.substr(range.begin, range.end - range.begin);
    const LanguageAt at = languageAt(text, byte, context);
    ReferenceEntry entry = referenceOf(word, at.language, context);
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

}  // namespace glibra::editor
