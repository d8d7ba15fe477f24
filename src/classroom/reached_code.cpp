#include "classroom/reached_code.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <map>
#include <string_view>
#include <utility>

#include "base/hash.h"
#include "classroom/normal_form.h"
#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"
#include "glsl/read/report.h"
#include "glsl/read/source.h"
#include "glsl/read/stage_text.h"
#include "glsl/read/words.h"

namespace glibra::classroom {
namespace {

std::string_view textAt(std::span<const CodeToken> tokens, std::size_t index) {
    return index < tokens.size() ? tokens[index].text : std::string_view{};
}

/// A word that the text may declare.
bool isName(const CodeToken& token) {
    return token.isWord && glsl::keywordSince(token.text) == 0;
}

/// The tokens of a stage, with the lines that have them: of what a macro stands for, that of its definition.
Code codeOf(const glsl::StageText& text) {
    Code code;
    for (const glsl::ViewToken& each : text.view) {
        const glsl::Token& token = text.tokens[each.raw];
        CodeLine line{token.line, token.file};
        if (token.body < text.macroTexts.size())
            line = {text.macroTexts[token.body].line, text.macroTexts[token.body].file};
        code.push_back(
            {each.text, 0, line, each.kind == glsl::TokenKind::word, each.kind == glsl::TokenKind::number});
    }
    dropPrecisions(code);
    return code;
}

/// Which items run. Functions are reached by calls, variables and structures by their names.
std::vector<bool> reachedItems(std::span<const CodeToken> code, std::span<const CodeItem> items) {
    std::multimap<std::string_view, std::size_t> functions, others;
    std::vector<std::size_t> open;
    bool hasMain = false;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const bool isCalled = items[i].parameters.data() != nullptr;
        for (const std::string_view name : items[i].names) (isCalled ? functions : others).emplace(name, i);
        const bool isMain = items[i].isFunction && items[i].names.front() == "main";
        hasMain = hasMain || isMain;
        // A subroutine is chosen by a uniform.
        if (isMain || items[i].names.empty() || code[items[i].begin].text == "subroutine") open.push_back(i);
    }
    std::vector<bool> reached(items.size(), !hasMain);
    if (!hasMain) return reached;
    const auto reach = [&](const auto& named, std::string_view name) {
        for (auto [each, end] = named.equal_range(name); each != end; ++each)
            if (!reached[each->second]) {
                reached[each->second] = true;
                open.push_back(each->second);
            }
    };
    for (const std::size_t each : open) reached[each] = true;
    while (!open.empty()) {
        const CodeItem& item = items[open.back()];
        open.pop_back();
        for (std::size_t i = item.begin; i < item.end; ++i) {
            if (!isName(code[i]) || (i > 0 && code[i - 1].text == ".")) continue;
            reach(others, code[i].text);
            if (textAt(code, i + 1) == "(") reach(functions, code[i].text);
        }
    }
    return reached;
}

/// The number of arguments or parameters before the ')' that closes them.
std::size_t countOf(std::span<const CodeToken> list) {
    return list.size() == 1 && list[0].text == "void" ? 0 : splitAtCommas(list).size();
}

/// Adds the names that the reached items call.
void addCalls(std::span<const CodeToken> code, std::span<const CodeItem> items,
              const std::vector<bool>& reached, std::set<std::string>& calls) {
    static const auto kBuiltIn = [] {
        const std::vector<std::string_view> all = glsl::coreFunctions();
        return std::set<std::string_view>(all.begin(), all.end());
    }();
    std::multimap<std::string_view, std::size_t> own;
    for (const CodeItem& each : items)
        if (each.parameters.data() != nullptr)
            for (const std::string_view name : each.names) own.emplace(name, countOf(each.parameters));
    for (std::size_t item = 0; item < items.size(); ++item) {
        if (!reached[item]) continue;
        for (std::size_t i = items[item].begin; i < items[item].end; ++i) {
            const std::string_view name = code[i].text;
            if (!code[i].isWord || textAt(code, i + 1) != "(") continue;
            // float f(float x)
            if (i > items[item].begin && code[i - 1].isWord && !glsl::isStatementWord(code[i - 1].text))
                continue;
            const auto [first, last] = own.equal_range(name);
            if (first != last && (kBuiltIn.contains(name) || name.starts_with("texture"))) {
                const std::size_t arguments = countOf(code.subspan(i + 2));
                if (std::any_of(first, last, [&](const auto& each) { return each.second == arguments; }))
                    continue;
            }
            if (!glsl::isStatementWord(name)) calls.emplace(name);
        }
    }
}

SourceFile runOf(const Code& tokens, const std::vector<std::string>& files) {
    SourceFile run{files.at(tokens.front().line.file), {}};
    for (const CodeToken& each : tokens) {
        SourceToken& token = run.tokens.emplace_back(SourceToken{each.code, each.line.number, 0});
        const std::string& path = files.at(each.line.file);
        if (path == run.path) continue;
        auto other = std::ranges::find(run.others, path);
        if (other == run.others.end()) other = run.others.insert(other, path);
        token.file = static_cast<std::uint32_t>(other - run.others.begin()) + 1;
    }
    return run;
}

std::uint64_t hashOf(std::span<const CodeToken> tokens) {
    std::uint64_t hash = 0;
    for (const CodeToken& each : tokens) hash = base::murmurMixed(hash * base::kGolden + each.code);
    return hash;
}

/// Adds what runs, in normal form: each function on its own, so that their order does not matter, and of each
/// file what is no function.
void addRuns(const Code& code, const OwnFunctions& own, const std::vector<std::string>& files,
             const InlineRule& rule, ReachedCode& result) {
    std::map<std::uint32_t, bool> isOwn;
    const auto mayInline = [&](const CodeItem& item) {
        const CodeToken& first = item.parameters.empty() ? *(item.parameters.data() - 1) : item.parameters[0];
        const auto [known, isNew] = isOwn.try_emplace(first.line.file);
        if (isNew) known->second = rule.isOwn && rule.isOwn(files.at(first.line.file));
        return known->second &&
               !rule.given.contains(hashOf(std::span(code).subspan(item.begin, item.end - item.begin)));
    };
    std::deque<std::string> names;
    const Code normal =
        inStatementOrder(inOrder(withoutDetours(code, own, mayInline, names), kNumberCode), own);
    const std::vector<CodeItem> items = itemsOf(normal);
    const std::vector<bool> reached = reachedItems(normal, items);
    std::map<std::uint32_t, Code> others;  // by file
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (!reached[i]) continue;
        const Code item(normal.begin() + static_cast<std::ptrdiff_t>(items[i].begin),
                        normal.begin() + static_cast<std::ptrdiff_t>(items[i].end));
        if (items[i].isFunction) {
            result.runs.push_back(runOf(item, files));
            continue;
        }
        Code& run = others[item.front().line.file];
        run.insert(run.end(), item.begin(), item.end());
    }
    for (const auto& [file, run] : others) result.runs.push_back(runOf(run, files));
}

void read(const glsl::StageSource& stage, const glsl::IncludeReader& include, const InlineRule& rule,
          bool hasExtensions, std::set<std::string>& calls, ReachedCode& result) {
    glsl::ProgramRequest request;
    request.include = include;
    if (hasExtensions) request.target.hasExtension = [](std::string_view) { return true; };
    glsl::StageText text;
    text.request = &request;
    glsl::Report report;  // the scene has been checked already
    glsl::readSource(stage, text, report);
    for (const Diagnostic& each : report.take())
        result.isWhole = result.isWhole && each.id != "glsl-E11" && each.id != "file-E09";
    const Code written = withLocalVariables(codeOf(text));
    const OwnFunctions own = ownFunctions(written);
    const Code code = withoutDeadCode(withoutLists(comparedCode(written, own)), own);
    const std::vector<CodeItem> items = itemsOf(code);
    const std::vector<bool> reached = reachedItems(code, items);
    if (!hasExtensions) addCalls(code, items, reached, calls);
    for (const CodeItem& each : items)
        if (each.isFunction)
            result.functions.push_back(hashOf(std::span(code).subspan(each.begin, each.end - each.begin)));
    addRuns(code, own, text.files, rule, result);
    const bool asksForExtensions = std::ranges::any_of(
        text.storage, [](const std::string& each) { return each.find("GL_") != std::string::npos; });
    if (!hasExtensions && asksForExtensions) read(stage, include, rule, true, calls, result);
}

}  // namespace

std::vector<CodeItem> itemsOf(std::span<const CodeToken> tokens) {
    std::vector<CodeItem> items;
    const CodeTree tree(tokens);
    for (const glsl::Declaration& each : tree.declarations()) {
        CodeItem& item = items.emplace_back(CodeItem{each.tokens.first, each.tokens.end});
        item.isFunction = each.kind == glsl::DeclarationKind::function;
        if (item.isFunction || each.kind == glsl::DeclarationKind::prototype) {
            const auto [first, end] = each.parameterTokens;
            const bool isClosed = end > first + 1 && tokens[end - 1].text == ")";
            item.parameters = tokens.subspan(first + 1, end - first - (isClosed ? 2 : 1));
        } else if (!each.type.isStruct && glsl::keywordSince(each.type.name) == 0 &&
                   !each.type.name.empty()) {
            item.names.push_back(each.type.name);
        }
        if (each.name != glsl::kNone) item.names.push_back(tokens[each.name].text);
        for (const glsl::Declarator& one : each.declarators) item.names.push_back(tokens[one.name].text);
    }
    return items;
}

bool hasEffect(std::string_view name) {
    return glsl::builtinOutputs(name) != 0 || name.starts_with("image") || name.starts_with("atomic") ||
           name.starts_with("emit") || name.starts_with("Emit") || name.starts_with("End") ||
           name.ends_with("arrier");
}

bool callsWithEffect(std::span<const CodeToken> code, const OwnFunctions& own) {
    for (std::size_t i = 0; i + 1 < code.size(); ++i) {
        if (!code[i].isWord || code[i + 1].text != "(") continue;
        const auto function = own.find(code[i].text);
        if (function == own.end() ? hasEffect(code[i].text) : function->second) return true;
    }
    return false;
}

bool hasEffect(std::span<const CodeToken> code, const OwnFunctions& own) {
    return callsWithEffect(code, own) || std::ranges::any_of(code, [](const CodeToken& each) {
               return glsl::isAssignment(each.text) || glsl::isStep(each.text);
           });
}

OwnFunctions ownFunctions(std::span<const CodeToken> tokens) {
    OwnFunctions own;
    std::multimap<std::string_view, std::string_view> callers;  // by what they call
    std::vector<std::string_view> open;
    const CodeTree tree(tokens);
    auto local = tree.locals().begin();
    for (const glsl::Declaration& item : tree.declarations()) {
        if (item.name == glsl::kNone) continue;
        const std::string_view name = tokens[item.name].text;
        if (item.type.isStruct) own.try_emplace(name, false);
        if (item.kind != glsl::DeclarationKind::function && item.kind != glsl::DeclarationKind::prototype)
            continue;
        bool& effect = own.try_emplace(name, false).first->second;
        std::set<std::string_view> locals;
        for (; local != tree.locals().end() && local->name < item.tokens.end; ++local)
            locals.insert(tokens[local->name].text);
        for (std::size_t i = item.tokens.first; i < item.tokens.end; ++i) {
            const std::string_view each = tokens[i].text;
            if (tokens[i].isWord && i != item.name && textAt(tokens, i + 1) == "(") {
                callers.emplace(each, name);
                effect = effect || hasEffect(each);
            }
            effect = effect || each == "discard" || each == "out" || each == "inout";
            if (glsl::isAssignment(each) || glsl::isStep(each))
                effect = effect || !locals.contains(targetOf(tokens, item.tokens.first, i));
        }
        if (effect) open.push_back(name);
    }
    while (!open.empty()) {
        const std::string_view called = open.back();
        open.pop_back();
        for (auto [each, end] = callers.equal_range(called); each != end; ++each)
            if (bool& effect = own.at(each->second); !effect) {
                effect = true;
                open.push_back(each->second);
            }
    }
    return own;
}

ReachedCode reachedCode(const glsl::StageSource& stage, const glsl::IncludeReader& include,
                        const InlineRule& rule) {
    ReachedCode result;
    std::set<std::string> calls;
    read(stage, include, rule, false, calls, result);
    result.calls.assign(calls.begin(), calls.end());
    return result;
}

}  // namespace glibra::classroom
