#include "editor/error_directives.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/emit/log.h"
#include "glsl/read/token.h"

namespace glibra::editor {
namespace {

/// "error" and " no such thing" of `#error no such thing`; empty for lines without a directive.
struct Directive {
    std::string_view name;
    std::string text;
};

Directive directiveOf(std::span<const glsl::Token> line) {
    Directive directive;
    bool isDirective = false;
    for (const glsl::Token& each : line) {
        const bool counts = glsl::isSignificant(each.kind);
        if (!directive.name.empty()) {
            if (each.kind != glsl::TokenKind::splice)
                directive.text += each.kind == glsl::TokenKind::comment ? " " : each.text;
        } else if (counts && !isDirective) {
            isDirective = each.text == "#";
            if (!isDirective) return {};
        } else if (counts) {
            directive.name = each.text;
        }
    }
    return directive;
}

/// The log that a driver would write about the #error lines of a stage. The translator has resolved all
/// conditions, and its #line directives give the number of the line after them, and of its file.
std::string logOf(const glsl::TranslatedStage& stage) {
    std::string log;
    std::deque<std::string> storage;
    const std::vector<glsl::Token> tokens = glsl::lex(stage.source, storage);
    int number = 1, file = 0;
    for (auto begin = tokens.begin(); begin != tokens.end();) {
        const auto end = std::find_if(begin, tokens.end(), [](const glsl::Token& each) {
            return each.kind == glsl::TokenKind::newline;
        });
        const Directive directive = directiveOf({begin, end});
        if (directive.name == "error")
            log += fmt::format("{}:{}(1): error: #error{}\n", file, number, directive.text);
        // Comments of several lines are one token.
        for (auto each = begin; each != end; ++each)
            number += static_cast<int>(std::ranges::count(each->text, '\n'));
        ++number;
        if (directive.name == "line") std::istringstream(directive.text) >> number >> file;
        begin = end == tokens.end() ? end : end + 1;
    }
    return log;
}

}  // namespace

Diagnostics errorDirectivesOf(const glsl::TranslatedProgram& program) {
    Diagnostics found;
    for (const glsl::TranslatedStage& each : program.stages)
        if (const std::string log = logOf(each); !log.empty())
            append(found, glsl::explainCompileLog(program, each, log));
    return found;
}

}  // namespace glibra::editor
