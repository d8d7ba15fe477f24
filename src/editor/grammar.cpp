#include "editor/grammar.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/page_template.h"
#include "base/texel_format.h"
#include "embedded/editor_grammars.h"
#include "expression/functions.h"
#include "expression/known_names.h"
#include "glib/statement_table.h"
#include "glib/text.h"
#include "glsl/types/stage.h"
#include "source/inline_shaders.h"

namespace glibra::editor {
namespace {

using Words = std::vector<std::string>;

/// The words of the language by what they are.
struct LanguageWords {
    Words statements;  ///< that a line begins with
    Words keys;        ///< other words that statements know
    Words functions;
    Words names;   ///< that every scene has
    Words stages;  ///< of shaders in the scene: "Fragment"
};

bool isPlainWord(std::string_view word) {
    return !word.empty() && !glib::isDigit(word.front()) && std::ranges::all_of(word, glib::isOfName);
}

LanguageWords languageWords() {
    std::set<std::string> statements, keys, functions, names;
    const auto add = [](std::set<std::string>& to, std::string_view word) {
        if (isPlainWord(word)) to.emplace(word);
    };
    for (const glib::StatementRow& row : glib::commandTable()) {
        for (const std::string_view name : row.names()) add(statements, name);
        for (const std::string& word : glib::wordsOf(row)) add(keys, word);
    }
    for (const glib::StatementRow& row : glib::statementTable()) {
        add(statements, row.name);
        for (const std::string& word : glib::wordsOf(row)) add(keys, word);
    }
    for (const base::TexelFormatRow& row : base::texelFormats()) add(keys, row.name);
    for (const glib::TextureFormat& format : glib::textureFormats()) add(keys, format.name);
    for (const char* each : {"true", "false", "on", "off", "inline", "of"}) add(keys, each);
    for (const expression::FunctionRow& row : expression::functionTable()) add(functions, row.name());
    for (const expression::NameRow& row : expression::sceneNames()) add(names, row.path);
    LanguageWords words{{statements.begin(), statements.end()},
                        {keys.begin(), keys.end()},
                        {functions.begin(), functions.end()},
                        {names.begin(), names.end()},
                        {}};
    for (int stage = 0; stage < glsl::kStageCount; ++stage)
        words.stages.push_back(source::endWordOf(static_cast<glsl::Stage>(stage)).substr(3));
    for (const std::string& each : words.stages) words.statements.push_back("End" + each);
    return words;
}

/// The words as alternatives of a regular expression, longer ones first.
std::string alternatives(Words words) {
    std::ranges::stable_sort(words,
                             [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
    return fmt::format("{}", fmt::join(words, "|"));
}

std::vector<GrammarFile> forVscode(const LanguageWords& words, std::string_view version) {
    Words openers, closers;
    for (const glib::StatementRow& row : glib::statementTable()) {
        if (row.role == glib::BlockRole::opens) openers.emplace_back(row.name);
        if (row.role == glib::BlockRole::closes || row.role == glib::BlockRole::divides)
            closers.emplace_back(row.name);
    }
    for (const char* each : {"glBegin", "PushMatrix", "TransformBegin", "Else"}) openers.emplace_back(each);
    for (const char* each : {"glEnd", "PopMatrix", "TransformEnd"}) closers.emplace_back(each);
    const base::Fields fields = {{"stages", words.stages},
                                 {"statements", alternatives(words.statements)},
                                 {"keys", alternatives(words.keys)},
                                 {"functions", alternatives(words.functions)},
                                 {"names", alternatives(words.names)},
                                 {"openers", alternatives(openers)},
                                 {"closers", alternatives(closers)},
                                 {"version", version}};
    return {
        {"syntaxes/glib.tmLanguage.json", base::filled(editor_grammars::glib_tmLanguage_json(), fields)},
        {"language-configuration.json", base::filled(editor_grammars::language_configuration_json(), fields)},
        {"package.json", base::filled(editor_grammars::package_json(), fields)}};
}

// ---- Vim

/// Words that are options of `syntax keyword`.
constexpr std::array<std::string_view, 16> kVimOptions{
    "contained", "containedin", "nextgroup",   "transparent", "skipwhite", "skipempty",
    "skipnl",    "conceal",     "concealends", "cchar",       "fold",      "display",
    "extend",    "oneline",     "contains",    "keepend"};

std::string vimKeywords(const char* group, const Words& words, const char* options = "") {
    std::string text;
    std::string line;
    for (const std::string& each : words) {
        if (std::ranges::find(kVimOptions, glib::lower(each)) != kVimOptions.end()) {
            text += fmt::format("syntax match {} /\\<{}\\>/{}\n", group, each, options);
            continue;
        }
        constexpr std::size_t kWidth = 100;
        if (line.size() + each.size() > kWidth) {
            text += fmt::format("syntax keyword {}{}{}\n", group, line, options);
            line.clear();
        }
        line += " " + each;
    }
    return text + (line.empty() ? "" : fmt::format("syntax keyword {}{}{}\n", group, line, options));
}

std::vector<GrammarFile> forVim(const LanguageWords& words) {
    // A keyword of Vim counts anywhere: a word that also begins statements would hide them.
    Words keys = words.keys;
    std::erase_if(keys, [&](const std::string& key) {
        return std::ranges::any_of(words.statements,
                                   [&](const std::string& each) { return glib::sameWord(each, key); });
    });
    const base::Fields fields = {{"stages", words.stages},
                                 {"keys", vimKeywords("glibKey", keys)},
                                 {"statements", vimKeywords("glibStatement", words.statements, " contained")},
                                 {"functions", vimKeywords("glibFunction", words.functions)},
                                 {"names", vimKeywords("glibName", words.names)}};
    return {{"syntax/glib.vim", base::filled(editor_grammars::glib_vim(), fields)},
            {"ftdetect/glib.vim", std::string(editor_grammars::ftdetect_vim())},
            {"ftplugin/glib.vim", std::string(editor_grammars::ftplugin_vim())}};
}

// ---- Kate

std::vector<GrammarFile> forKate(const LanguageWords& words) {
    const base::Fields fields = {{"stages", words.stages},
                                 {"statements", words.statements},
                                 {"keys", words.keys},
                                 {"functions", words.functions},
                                 {"names", words.names}};
    return {{"glib.xml", base::filled(editor_grammars::glib_xml(), fields)}};
}

}  // namespace

std::vector<GrammarFile> grammarOf(GrammarEditor editor, std::string_view version) {
    const LanguageWords words = languageWords();
    switch (editor) {
        case GrammarEditor::vscode:
            return forVscode(words, version);
        case GrammarEditor::vim:
            return forVim(words);
        case GrammarEditor::kate:
            break;
    }
    return forKate(words);
}

}  // namespace glibra::editor
