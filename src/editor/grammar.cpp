#include "editor/grammar.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/texel_format.h"
#include "expression/functions.h"
#include "expression/known_names.h"
#include "glib/statement_table.h"
#include "glib/text.h"
#include "glsl/types/stage.h"
#include "source/inline_shaders.h"

namespace glibra::editor {
namespace {

using Json = nlohmann::ordered_json;
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

// ---- Visual Studio Code

constexpr const char* kNumber = R"((?<![\w.])[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)";

Json named(const char* name, const std::string& pattern) {
    return {{"name", name}, {"match", pattern}};
}

std::string textMateGrammar(const LanguageWords& words) {
    Json patterns = Json::array();
    for (const std::string& each : words.stages)
        patterns.push_back(
            {{"begin", fmt::format(R"((?i)^\s*({})\s+(inline)\b)", each)},
             {"end", fmt::format(R"((?i)^\s*(End{})\s*$)", each)},
             {"beginCaptures",
              {{"1", {{"name", "keyword.control.glib"}}}, {"2", {{"name", "storage.modifier.glib"}}}}},
             {"endCaptures", {{"1", {{"name", "keyword.control.glib"}}}}},
             {"contentName", "meta.embedded.block.glsl"},
             {"patterns", Json::array({{{"include", "source.glsl"}}})}});
    patterns.push_back(
        {{"match", R"((?i)^\s*(MessageBox)\b(.*)$)"},
         {"captures",
          {{"1", {{"name", "keyword.control.glib"}}}, {"2", {{"name", "string.unquoted.glib"}}}}}});
    patterns.push_back(named("comment.line.glib", R"((?:#|//|(?<!\S)/).*$)"));
    patterns.push_back(named("string.quoted.double.glib", R"("[^"]*"?)"));
    patterns.push_back({{"match", fmt::format(R"((?i)^\s*({})(?![\w.]))", alternatives(words.statements))},
                        {"captures", {{"1", {{"name", "keyword.control.glib"}}}}}});
    patterns.push_back(named("support.function.glib",
                             fmt::format(R"((?<![\w.])({})(?=\s*\())", alternatives(words.functions))));
    patterns.push_back(
        named("variable.language.glib", fmt::format(R"((?<![\w.])({})(?!\w))", alternatives(words.names))));
    patterns.push_back(
        named("storage.modifier.glib", fmt::format(R"((?i)(?<![\w.])({})(?!\w))", alternatives(words.keys))));
    patterns.push_back(named("constant.numeric.glib", kNumber));
    patterns.push_back(named("constant.character.escape.glib", R"(\\\s*$)"));
    const Json grammar = {
        {"$schema", "https://raw.githubusercontent.com/martinring/tmlanguage/master/tmlanguage.json"},
        {"name", "GLIB scene"},
        {"scopeName", "source.glib"},
        {"fileTypes", {"glib"}},
        {"patterns", patterns}};
    return grammar.dump(2) + "\n";
}

std::vector<GrammarFile> forVscode(const LanguageWords& words, std::string_view version) {
    Words openers, closers;
    for (const glib::StatementRow& row : glib::statementTable()) {
        if (row.role == glib::BlockRole::opens) openers.emplace_back(row.name);
        if (row.role == glib::BlockRole::closes || row.role == glib::BlockRole::divides)
            closers.emplace_back(row.name);
    }
    for (const char* each : {"glBegin", "PushMatrix", "TransformBegin"}) openers.emplace_back(each);
    for (const char* each : {"glEnd", "PopMatrix", "TransformEnd"}) closers.emplace_back(each);
    Words divided = openers;
    divided.emplace_back("Else");
    Json brackets = Json::array();
    for (const auto& [open, close] : {std::pair{"{", "}"}, {"[", "]"}, {"(", ")"}})
        brackets.push_back(Json::array({open, close}));
    Json pairList = brackets;
    pairList.push_back(Json::array({"\"", "\""}));
    const Json configuration = {
        {"comments", {{"lineComment", "#"}}},
        {"brackets", brackets},
        {"autoClosingPairs", pairList},
        {"surroundingPairs", pairList},
        {"indentationRules",
         {{"increaseIndentPattern", fmt::format(R"(^\s*({})\b)", alternatives(divided))},
          {"decreaseIndentPattern", fmt::format(R"(^\s*({})\b)", alternatives(closers))}}}};
    const Json package = {
        {"name", "glibra"},
        {"displayName", "GLIB scenes"},
        {"description", "Syntax colours for GLIB shader scenes"},
        {"version", version},
        {"publisher", "glibra"},
        {"license", "MIT"},
        {"engines", {{"vscode", "^1.75.0"}}},
        {"categories", Json::array({"Programming Languages"})},
        {"contributes",
         {{"languages", Json::array({{{"id", "glib"},
                                      {"aliases", Json::array({"GLIB scene", "glib"})},
                                      {"extensions", Json::array({".glib"})},
                                      {"configuration", "./language-configuration.json"}}})},
          {"grammars", Json::array({{{"language", "glib"},
                                     {"scopeName", "source.glib"},
                                     {"path", "./syntaxes/glib.tmLanguage.json"},
                                     {"embeddedLanguages", {{"meta.embedded.block.glsl", "glsl"}}}}})}}}};
    return {{"syntaxes/glib.tmLanguage.json", textMateGrammar(words)},
            {"language-configuration.json", configuration.dump(2) + "\n"},
            {"package.json", package.dump(2) + "\n"}};
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
    std::string text =
        "\" Vim syntax file: GLIB shader scenes. Made by `glibra language --grammar vim`.\n"
        "if exists('b:current_syntax')\n  finish\nendif\n"
        "try\n  syntax include @glibGlsl syntax/glsl.vim\ncatch\nendtry\nunlet! b:current_syntax\n"
        "syntax case ignore\n"
        "syntax match glibNumber /\\%(\\w\\|\\.\\)\\@<![+-]\\=\\%(\\d\\+\\.\\=\\d*\\|\\.\\d\\+\\)"
        "\\%(e[+-]\\=\\d\\+\\)\\=/\n"
        "syntax match glibLine /^\\s*\\h\\w*/ contains=glibStatement\n"
        "syntax match glibContinued /\\\\\\s*$/\n"
        "syntax region glibString start=/\"/ end=/\"/ oneline\n"
        "syntax match glibComment /#.*$/\n"
        "syntax match glibComment /\\/\\/.*$/\n"
        "syntax match glibComment /\\S\\@1<!\\/.*$/\n"
        "syntax match glibMessage /\\%(^\\s*MessageBox\\)\\@<=\\s.*$/\n";
    // A keyword of Vim counts anywhere: a word that also begins statements would hide them.
    Words keys = words.keys;
    std::erase_if(keys, [&](const std::string& key) {
        return std::ranges::any_of(words.statements,
                                   [&](const std::string& each) { return glib::sameWord(each, key); });
    });
    text += vimKeywords("glibKey", keys);
    text += vimKeywords("glibStatement", words.statements, " contained");
    text += "syntax case match\n";
    text += vimKeywords("glibFunction", words.functions);
    text += vimKeywords("glibName", words.names);
    text += "syntax case ignore\n";
    for (const std::string& each : words.stages)
        text += fmt::format(
            "syntax region glibShader matchgroup=glibStatement start=/^\\s*{0}\\s\\+inline\\>.*$/ "
            "end=/^\\s*End{0}\\s*$/ contains=@glibGlsl keepend\n",
            each);
    text +=
        "syntax sync fromstart\n"
        "highlight default link glibComment Comment\nhighlight default link glibStatement Statement\n"
        "highlight default link glibKey Type\nhighlight default link glibFunction Function\n"
        "highlight default link glibName Identifier\nhighlight default link glibNumber Number\n"
        "highlight default link glibString String\nhighlight default link glibMessage String\n"
        "highlight default link glibContinued Special\n"
        "let b:current_syntax = 'glib'\n";
    return {{"syntax/glib.vim", text},
            {"ftdetect/glib.vim", "autocmd BufRead,BufNewFile *.glib setfiletype glib\n"},
            {"ftplugin/glib.vim",
             "setlocal commentstring=#\\ %s comments=:#,:// shiftwidth=4 expandtab\n"
             "let b:undo_ftplugin = 'setlocal commentstring< comments< shiftwidth< expandtab<'\n"}};
}

// ---- Kate

std::vector<GrammarFile> forKate(const LanguageWords& words) {
    const auto list = [](const char* name, const Words& all) {
        std::string text = fmt::format("    <list name=\"{}\">\n", name);
        for (const std::string& each : all) text += fmt::format("      <item>{}</item>\n", each);
        return text + "    </list>\n";
    };
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE language>\n"
        "<!-- Made by the program glibra from its tables. -->\n"
        "<language name=\"GLIB\" version=\"1\" kateversion=\"5.0\" section=\"3D\" extensions=\"*.glib\" "
        "casesensitive=\"0\" license=\"MIT\">\n  <highlighting>\n";
    text += list("statements", words.statements) + list("keys", words.keys) +
            list("functions", words.functions) + list("names", words.names);
    text +=
        "    <contexts>\n      <context name=\"Scene\" attribute=\"Normal Text\" lineEndContext=\"#stay\">\n"
        "        <DetectSpaces/>\n";
    for (const std::string& each : words.stages)
        text += fmt::format(
            "        <RegExpr attribute=\"Statement\" context=\"{0} Shader\" String=\"\\b{0}\\s+inline\\b\" "
            "firstNonSpace=\"1\" insensitive=\"1\" beginRegion=\"Shader\"/>\n",
            each);
    text +=
        "        <WordDetect attribute=\"Statement\" context=\"Message\" String=\"MessageBox\" "
        "firstNonSpace=\"1\" insensitive=\"1\"/>\n"
        "        <keyword attribute=\"Statement\" context=\"#stay\" String=\"statements\" "
        "firstNonSpace=\"1\"/>\n"
        "        <DetectChar attribute=\"Comment\" context=\"Comment\" char=\"#\"/>\n"
        "        <Detect2Chars attribute=\"Comment\" context=\"Comment\" char=\"/\" char1=\"/\"/>\n"
        "        <DetectChar attribute=\"String\" context=\"String\" char=\"&quot;\"/>\n"
        "        <keyword attribute=\"Function\" context=\"#stay\" String=\"functions\"/>\n"
        "        <keyword attribute=\"Name\" context=\"#stay\" String=\"names\"/>\n"
        "        <keyword attribute=\"Key\" context=\"#stay\" String=\"keys\"/>\n"
        "        <DetectIdentifier/>\n"
        "        <Float attribute=\"Number\" context=\"#stay\"/>\n"
        "        <Int attribute=\"Number\" context=\"#stay\"/>\n"
        "      </context>\n"
        "      <context name=\"Comment\" attribute=\"Comment\" lineEndContext=\"#pop\"/>\n"
        "      <context name=\"Message\" attribute=\"String\" lineEndContext=\"#pop\"/>\n"
        "      <context name=\"String\" attribute=\"String\" lineEndContext=\"#pop\">\n"
        "        <DetectChar attribute=\"String\" context=\"#pop\" char=\"&quot;\"/>\n"
        "      </context>\n";
    for (const std::string& each : words.stages)
        text += fmt::format(
            "      <context name=\"{0} Shader\" attribute=\"Normal Text\" lineEndContext=\"#stay\">\n"
            "        <RegExpr attribute=\"Statement\" context=\"#pop\" String=\"\\bEnd{0}\\s*$\" "
            "firstNonSpace=\"1\" insensitive=\"1\" endRegion=\"Shader\"/>\n"
            "        <IncludeRules context=\"##GLSL\" includeAttrib=\"1\"/>\n"
            "      </context>\n",
            each);
    text +=
        "    </contexts>\n    <itemDatas>\n"
        "      <itemData name=\"Normal Text\" defStyleNum=\"dsNormal\"/>\n"
        "      <itemData name=\"Statement\" defStyleNum=\"dsKeyword\"/>\n"
        "      <itemData name=\"Key\" defStyleNum=\"dsDataType\"/>\n"
        "      <itemData name=\"Function\" defStyleNum=\"dsFunction\"/>\n"
        "      <itemData name=\"Name\" defStyleNum=\"dsVariable\"/>\n"
        "      <itemData name=\"Number\" defStyleNum=\"dsFloat\"/>\n"
        "      <itemData name=\"String\" defStyleNum=\"dsString\"/>\n"
        "      <itemData name=\"Comment\" defStyleNum=\"dsComment\"/>\n"
        "    </itemDatas>\n  </highlighting>\n  <general>\n"
        "    <comments><comment name=\"singleLine\" start=\"#\"/></comments>\n"
        "    <keywords casesensitive=\"0\"/>\n  </general>\n</language>\n";
    return {{"glib.xml", text}};
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
