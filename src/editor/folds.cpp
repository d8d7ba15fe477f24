#include "editor/folds.h"

#include <algorithm>
#include <deque>
#include <string>

#include "editor/completion.h"
#include "glib/parse/statement.h"
#include "glsl/read/token.h"

namespace glibra::editor {
namespace {

void addShaderFolds(std::vector<Fold>& folds, std::string_view text, std::size_t linesBefore) {
    std::string normal(text);  // with as many lines
    std::ranges::replace(normal, '\r', ' ');
    std::deque<std::string> storage;
    const std::vector<glsl::Token> tokens = glsl::lex(normal, storage);
    std::vector<std::size_t> open, conditions;
    const auto close = [&](std::vector<std::size_t>& from, std::size_t last) {
        if (from.empty()) return;
        if (last > from.back()) folds.push_back({from.back(), last, false});
        from.pop_back();
    };
    std::string_view before;  // in the line
    for (const glsl::Token& each : tokens) {
        const std::size_t line = linesBefore + static_cast<std::size_t>(each.line) - 1;
        if (each.kind == glsl::TokenKind::comment) {
            const auto lines = static_cast<std::size_t>(std::ranges::count(each.text, '\n'));
            if (lines > 0) folds.push_back({line, line + lines, true});
        } else if (each.text == "{") {
            open.push_back(line);
        } else if (each.text == "}") {
            close(open, line > 0 ? line - 1 : 0);
        } else if (before == "#" && each.text.starts_with("if")) {
            conditions.push_back(line);
        } else if (before == "#" && (each.text == "endif" || each.text == "else" || each.text == "elif")) {
            close(conditions, line > 0 ? line - 1 : 0);
            if (each.text != "endif") conditions.push_back(line);
        }
        if (each.kind == glsl::TokenKind::newline || glsl::isSignificant(each.kind)) before = each.text;
    }
}

}  // namespace

std::vector<Fold> foldsOf(std::string_view text, source::CodeLanguage language) {
    std::vector<Fold> folds;
    if (language == source::CodeLanguage::glsl) {
        addShaderFolds(folds, text, 0);
        return folds;
    }
    std::vector<std::size_t> open;
    for (const glib::Statement& each : glib::statementsOf(text)) {
        const auto line = static_cast<std::size_t>(each.word.position.line) - 1;
        if (each.body.data() != nullptr) {
            const auto begin = static_cast<std::size_t>(each.bodyPosition.line) - 1;
            const auto lines = static_cast<std::size_t>(std::ranges::count(each.body, '\n'));
            if (lines > 0) folds.push_back({line, begin + lines - 1, false});
            addShaderFolds(folds, each.body, begin);
        } else if (each.modern && each.modern->role == glib::BlockRole::opens) {
            open.push_back(line);
        } else if (each.modern && each.modern->role == glib::BlockRole::closes && !open.empty()) {
            if (line > open.back() + 1) folds.push_back({open.back(), line - 1, false});
            open.pop_back();
        }
    }
    return folds;
}

}  // namespace glibra::editor
