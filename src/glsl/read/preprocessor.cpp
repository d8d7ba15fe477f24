#include "glsl/read/preprocessor.h"

#include <algorithm>
#include <utility>

#include "glsl/read/condition.h"
#include "glsl/read/predefined.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

constexpr int kFirstWithPasting = 130;

std::string quoted(std::string_view text) {
    return "'" + std::string(text) + "'";
}

/// The type of what a macro stands for, if it is a number or made by a constructor; otherwise empty.
std::string_view typeOf(const Macro& macro) {
    for (const BodyToken& each : macro.body) {
        if (each.kind == TokenKind::word && isTypeWord(each.text)) return each.text;
        if (each.kind != TokenKind::number) continue;
        const bool isHex = each.text.starts_with("0x") || each.text.starts_with("0X");
        if (!isHex && each.text.find_first_of(".eEfF") != std::string_view::npos) return "float";
        if (each.text.find_first_of("uU") != std::string_view::npos) return "uint";
        return {};
    }
    return {};
}

Piece zeroOrOne(bool one, const Piece& place) {
    Piece piece = place;
    piece.token.text = one ? "1" : "0";
    piece.token.kind = TokenKind::number;
    return piece;
}

}  // namespace

bool Preprocessor::perform(std::string_view directive, const SourceLine& line) {
    if (directive == "if" || directive == "ifdef" || directive == "ifndef" || directive == "elif" ||
        directive == "else" || directive == "endif") {
        conditional(directive, line);
        return true;
    }
    if (directive != "define" && directive != "undef") return false;
    if (!active_) return true;
    if (hasName(directive, line)) directive == "define" ? define(line) : undefine(line);
    return true;
}

void Preprocessor::conditional(std::string_view directive, const SourceLine& line) {
    if (directive == "if" || directive == "ifdef" || directive == "ifndef") {
        conditionals_.push_back({active_, false, false, line.token(0)});
        const bool holds =
            active_ && (directive == "if" ? condition(directive, line)
                                          : hasName(directive, line) &&
                                                expander_.isDefined(line.word(2)) == (directive == "ifdef"));
        branch(holds);
    } else if (conditionals_.empty()) {
        complain("'#" + std::string(directive) + "' without '#if'", line.token(0));
    } else if (directive == "endif") {
        active_ = conditionals_.back().outer;
        conditionals_.pop_back();
    } else {
        nextBranch(directive, line);
    }
}

void Preprocessor::nextBranch(std::string_view directive, const SourceLine& line) {
    Conditional& current = conditionals_.back();
    if (current.hasElse && current.outer)
        complain("'#" + std::string(directive) + "' after '#else'", line.token(0));
    const bool isOpen = current.outer && !current.taken && !current.hasElse;
    current.hasElse = current.hasElse || directive == "else";
    // A condition after the branch that is compiled is not read.
    branch(isOpen && (directive == "else" || condition(directive, line)));
}

void Preprocessor::branch(bool taken) {
    active_ = taken;
    if (taken) conditionals_.back().taken = true;
}

void Preprocessor::finish() {
    if (!conditionals_.empty()) complain("this branch has no '#endif'", conditionals_.back().start);
}

bool Preprocessor::hasName(std::string_view directive, const SourceLine& line) {
    if (line.significant.size() > 2 && line.significant[2]->kind == TokenKind::word) return true;
    complain("expected a name after '#" + std::string(directive) + "'", line.token(2));
    return false;
}

void Preprocessor::evaluateDefined(std::vector<Piece>& pieces, std::string_view directive,
                                   const SourceLine& line) {
    std::vector<Piece> result;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].token.text != "defined") {
            result.push_back(pieces[i]);
            continue;
        }
        const auto is = [&](std::size_t at, std::string_view text) {
            return at < pieces.size() && pieces[at].token.text == text;
        };
        const bool bracket = is(i + 1, "(");
        const std::size_t at = i + (bracket ? 2 : 1);
        if (at >= pieces.size() || pieces[at].token.kind != TokenKind::word ||
            (bracket && !is(at + 1, ")"))) {
            complain("#" + std::string(directive) + ": expected 'defined NAME' or 'defined(NAME)'",
                     line.token(0));
            result.push_back(zeroOrOne(false, pieces[i]));
            break;
        }
        result.push_back(zeroOrOne(expander_.isDefined(pieces[at].token.text), pieces[i]));
        i = at + (bracket ? 1 : 0);
    }
    pieces = std::move(result);
}

bool Preprocessor::condition(std::string_view directive, const SourceLine& line) {
    std::vector<Piece> pieces;
    for (std::size_t i = 2; i < line.significant.size(); ++i) {
        pieces.push_back({*line.significant[i]});
        const std::string_view before = line.word(i - 1), around = line.word(i - 2);
        if (before == "defined" || (before == "(" && around == "defined")) continue;
        const Constant* const constant = expander_.constantNamed(line.word(i));
        if (constant != nullptr && constant->isBoolean && constant->components.size() == 1)
            pieces.back() = zeroOrOne(constant->components[0] != 0, pieces.back());
    }
    evaluateDefined(pieces, directive, line);
    pieces = expander_.expand(std::move(pieces));
    evaluateDefined(pieces, directive, line);  // a macro may have written the word
    const Condition found = evaluateCondition(pieces);
    const std::string start = "#" + std::string(directive) + ": ";
    if (!found.error.empty()) {
        complain(start + found.error, found.at ? found.at->token : line.token(line.significant.size()));
        return false;
    }
    if (found.unknown) {
        const std::string name = quoted(found.unknown->token.text);
        if (stage_.dialect.es)
            complain(start + name + " is not defined; GLSL ES demands a macro here, or 'defined'",
                     found.unknown->token);
        else if (!isReservedMacro(found.unknown->token.text))
            complain_("glsl-W24", name + " is not defined, so it counts as 0 here", found.unknown->token);
    }
    return found.value != 0;
}

std::vector<Piece> Preprocessor::expanded(const SourceLine& line, std::size_t first) {
    std::vector<Piece> pieces;
    for (std::size_t i = first; i < line.significant.size(); ++i) pieces.push_back({*line.significant[i]});
    return expander_.expand(std::move(pieces));
}

void Preprocessor::undefine(const SourceLine& line) {
    if (isReservedMacro(line.word(2)))
        complain(quoted(line.word(2)) + " is predefined; it cannot be undefined", line.token(2));
    else
        expander_.macros().undefine(line.word(2));
}

void Preprocessor::define(const SourceLine& line) {
    const Token* const name = line.significant[2];
    Macro macro;
    macro.line = name->line;
    // A parenthesis begins the parameters only if it follows the name without a blank.
    const Token* next = name + 1;
    const Token* const end = line.tokens.data() + line.tokens.size();
    while (next != end && next->kind == TokenKind::splice) ++next;
    std::size_t at = 3;
    if (next != end && next->text == "(" && !defineParameters(line, macro, at)) return;
    defineBody(line, macro, at);
    if (!macro.body.empty() && (macro.body.front().text == "##" || macro.body.back().isPasted))
        return complain("'##' cannot begin or end the text of a macro", *name);
    if (name->text.starts_with("glibra_"))
        return complain_("glsl-E05", "names beginning with 'glibra_' are reserved", *name);
    if (name->text == "defined") return complain("'defined' cannot be the name of a macro", *name);
    if (const Constant* const constant = expander_.constantNamed(name->text)) {
        if (macro.takesArguments)
            return complain_(
                "glsl-E18",
                quoted(name->text) + " takes arguments here, and the scene gives it " + valueText(*constant),
                *name);
        if (!constant->components.empty()) {
            expander_.defineConstant(*constant, typeOf(macro), *name);
            return;
        }
        expander_.macros().undefine(name->text);
    }
    const Macro* const known = expander_.find(name->text);
    if (isReservedMacro(name->text)) {
        // Some sources make up for a driver that lacks an extension's macro.
        const bool isSame =
            known && !macro.takesArguments && macro.body.size() == 1 && macro.body[0].text == "1";
        if (!isSame) complain("the name " + quoted(name->text) + " is reserved for predefined macros", *name);
        return;
    }
    if (known && !known->isSameAs(macro))
        return complain(quoted(name->text) + " is already defined with another text in line " +
                            std::to_string(known->line) + "; write '#undef " + std::string(name->text) +
                            "' first",
                        *name);
    if (!known) expander_.macros().define(name->text, std::move(macro));
}

bool Preprocessor::defineParameters(const SourceLine& line, Macro& macro, std::size_t& at) {
    macro.takesArguments = true;
    at = 4;
    if (line.word(at) == ")") {
        ++at;
        return true;
    }
    for (;; at += 2) {
        const bool isName = at < line.significant.size() && line.significant[at]->kind == TokenKind::word;
        const std::string_view name = line.word(at);
        if (!isName) {
            complain("expected the name of a parameter" + (name.empty() ? "" : ", found " + quoted(name)),
                     line.token(at));
            return false;
        }
        if (std::ranges::find(macro.parameters, name) != macro.parameters.end()) {
            complain("two parameters have the name " + quoted(name), line.token(at));
            return false;
        }
        macro.parameters.push_back(name);
        if (line.word(at + 1) == ",") continue;
        if (line.word(at + 1) == ")") break;
        complain("expected ',' or ')' after the parameter " + quoted(name), line.token(at + 1));
        return false;
    }
    at += 2;
    return true;
}

void Preprocessor::defineBody(const SourceLine& line, Macro& macro, std::size_t first) {
    bool paste = false;
    for (std::size_t i = first; i < line.significant.size(); ++i) {
        const Token& token = *line.significant[i];
        if (token.text == "##" && !macro.body.empty() && i > first) {
            macro.body.back().isPasted = paste = true;
            const Dialect& dialect = stage_.dialect;
            if ((dialect.es || dialect.version < kFirstWithPasting) && !std::exchange(reportedPasting_, true))
                complain_("glsl-W25", "'##' came with GLSL 1.30, accepted", token);
            continue;
        }
        BodyToken& to = macro.body.emplace_back();
        to.text = token.text;
        to.kind = token.kind;
        to.isAfterPaste = std::exchange(paste, false);
        const auto parameter = std::ranges::find(macro.parameters, token.text);
        if (token.kind == TokenKind::word && parameter != macro.parameters.end())
            to.parameter = static_cast<int>(parameter - macro.parameters.begin());
        for (const Token* before = &token - 1; before != line.significant[i - 1]; --before)
            to.blank = to.blank || before->kind == TokenKind::blank || before->kind == TokenKind::comment;
        to.body = static_cast<std::uint32_t>(stage_.macroTexts.size());
        stage_.macroTexts.push_back({line.word(2), token.line, token.column, token.file});
    }
}

std::string SourceLine::includedName() const {
    if (significant.size() < 3) return {};
    const char* const begin = significant[2]->text.data();
    // The tokens of a line are adjacent in the text. What looks like a comment may belong to the name.
    const char* end = begin;
    for (const Token* each = significant[2]; each <= &tokens.back(); ++each)
        if (each->kind != TokenKind::splice && each->kind != TokenKind::newline)
            end = each->text.data() + each->text.size();
    const std::string_view rest(begin, static_cast<std::size_t>(end - begin));
    if (rest.empty()) return {};
    if (rest.front() != '<' && rest.front() != '"')
        return significant.size() == 3 && significant[2]->kind == TokenKind::word
                   ? std::string(significant[2]->text)
                   : std::string();
    const std::size_t close = rest.find(rest.front() == '<' ? '>' : '"', 1);
    return close == std::string_view::npos ? std::string{} : std::string(rest.substr(1, close - 1));
}

std::string SourceLine::joined() const {
    std::string text;
    for (const Token* each = significant.front(); each <= significant.back(); ++each)
        text += isSignificant(each->kind) ? each->text : std::string_view(" ");
    return text;
}

}  // namespace glibra::glsl
