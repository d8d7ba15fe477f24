#include "glsl/read/preprocessor.h"

#include "glsl/read/extensions.h"

namespace glibra::glsl {
namespace {

ViewToken viewOf(const Token& token) {
    ViewToken view;
    view.text = token.text;
    view.kind = token.kind;
    return view;
}

ViewToken numberToken(bool one) {
    ViewToken token;
    token.text = one ? "1" : "0";
    token.kind = TokenKind::number;
    return token;
}

}  // namespace

void Preprocessor::flush() {
    macros_.expand(pending_, stage_.view);
    pending_.clear();
}

bool Preprocessor::perform(std::string_view directive, const SourceLine& line) {
    if (directive == "if" || directive == "ifdef" || directive == "ifndef" || directive == "elif" ||
        directive == "else" || directive == "endif") {
        conditional(directive, line);
        return true;
    }
    if (directive != "define" && directive != "undef") return false;
    if (!active_ || line.word(2).empty()) return true;
    flush();
    if (directive == "define")
        define(line);
    else
        macros_.undefine(line.word(2));
    return true;
}

void Preprocessor::conditional(std::string_view directive, const SourceLine& line) {
    if (directive == "if" || directive == "ifdef" || directive == "ifndef") {
        conditionals_.push_back({active_, false});
        const bool holds = directive == "if"
                               ? active_ && condition(line)
                               : !line.word(2).empty() && isDefined(line.word(2)) == (directive == "ifdef");
        branch(active_ && holds);
        return;
    }
    if (conditionals_.empty()) return;
    if (directive == "endif") {
        active_ = conditionals_.back().outer;
        conditionals_.pop_back();
    } else {
        const bool open = conditionals_.back().outer && !conditionals_.back().taken;
        active_ = false;
        branch(open && (directive == "else" || condition(line)));
    }
}

void Preprocessor::branch(bool taken) {
    active_ = taken;
    if (taken) conditionals_.back().taken = true;
}

bool Preprocessor::isDefined(std::string_view name) const {
    if (macros_.isDefined(name) || name == "__VERSION__" || name == "__LINE__" || name == "__FILE__")
        return true;
    if (name == "GL_core_profile") return true;
    if (name == "GL_compatibility_profile") return !stage_.dialect.core;
    if (!name.starts_with("GL_")) return false;
    const Target& target = stage_.request->target;
    if (isInCore(name, target.version)) return true;
    return target.hasExtension && target.hasExtension(name);
}

bool Preprocessor::condition(const SourceLine& line) {
    std::vector<ViewToken> tokens;
    for (std::size_t i = 2; i < line.significant.size(); ++i) {
        if (line.word(i) != "defined") {
            tokens.push_back(viewOf(*line.significant[i]));
            continue;
        }
        const bool bracket = line.word(i + 1) == "(";
        const std::size_t at = i + (bracket ? 2 : 1);
        tokens.push_back(numberToken(isDefined(line.word(at))));
        i = at + (bracket ? 1 : 0);
    }
    std::vector<ViewToken> expanded;
    macros_.expand(tokens, expanded);
    for (ViewToken& each : expanded) predefined(each);
    long long value = 0;
    return evaluateCondition(expanded, value) && value != 0;
}

void Preprocessor::predefined(ViewToken& token) {
    if (token.kind != TokenKind::word) return;
    if (token.text == "__VERSION__") {
        stage_.storage.push_back(std::to_string(stage_.dialect.written));
        token.text = stage_.storage.back();
        token.kind = TokenKind::number;
    } else if (isDefined(token.text)) {
        token = numberToken(true);
    }
}

bool Preprocessor::number(const SourceLine& line, std::size_t first, long long& value) {
    std::vector<ViewToken> tokens, expanded;
    for (std::size_t i = first; i < line.significant.size(); ++i)
        tokens.push_back(viewOf(*line.significant[i]));
    macros_.expand(tokens, expanded);
    return !expanded.empty() && evaluateCondition(std::span(expanded).first(1), value);
}

void Preprocessor::define(const SourceLine& line) {
    const Token* const name = line.significant[2];
    stage_.macros.emplace(name->text);
    Macro macro;
    // A parenthesis begins the parameters only if it follows the name without a blank.
    const Token* const next = name + 1;
    std::size_t at = 3;
    if (next != line.tokens.data() + line.tokens.size() && next->text == "(") {
        macro.takesArguments = true;
        for (at = 4; at < line.significant.size() && line.word(at) != ")"; ++at)
            if (line.significant[at]->kind == TokenKind::word) macro.parameters.push_back(line.word(at));
        ++at;
    }
    for (; at < line.significant.size(); ++at) {
        ViewToken token = viewOf(*line.significant[at]);
        token.raw = token.site =
            line.first + static_cast<std::uint32_t>(line.significant[at] - line.tokens.data());
        token.body = true;
        macro.body.push_back(token);
    }
    macros_.define(name->text, std::move(macro));
}

}  // namespace glibra::glsl
