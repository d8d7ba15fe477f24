#include "glsl/read/preprocessor.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "glsl/read/words.h"

namespace glibra::glsl {

// ---- Conditions

namespace {

constexpr int kDeepestCondition = 200;

/// Precedence climbing over C's integer operators, in 64 bits.
class ConditionParser {
  public:
    explicit ConditionParser(std::span<const Piece> pieces) : pieces_(pieces) {}

    Condition run() {
        result_.value = binary(0);
        if (isGood() && at_ < pieces_.size())
            fail(peek() == ")" ? "a ')' has no '('"
                               : "expected an operator before '" + std::string(peek()) + "'");
        return std::move(result_);
    }

  private:
    [[nodiscard]] bool isGood() const { return result_.error.empty(); }
    [[nodiscard]] std::string_view peek() const {
        return at_ < pieces_.size() ? pieces_[at_].token.text : std::string_view{};
    }

    long long fail(std::string error) {
        if (isGood()) {
            result_.error = std::move(error);
            result_.at = at_ < pieces_.size() ? &pieces_[at_] : nullptr;
        }
        at_ = pieces_.size();
        return 0;
    }

    long long binary(int lowest) {
        if (++depth_ > kDeepestCondition) return fail("more than 200 expressions inside each other");
        long long left = unary();
        while (isGood() && at_ < pieces_.size()) {
            const std::string_view op = peek();
            const int level = op == "^^" ? 0 : levelOf(op);  // the preprocessor has C's operators
            if (level <= lowest) break;
            ++at_;
            const bool isDecided = (op == "||" && left != 0) || (op == "&&" && left == 0);
            skipped_ += isDecided ? 1 : 0;
            const long long right = binary(level);
            skipped_ -= isDecided ? 1 : 0;
            left = apply(op, left, right);
        }
        --depth_;
        return left;
    }

    long long apply(std::string_view op, long long a, long long b) {
        const auto x = static_cast<unsigned long long>(a);
        const auto y = static_cast<unsigned long long>(b);
        if (op == "||") return (a != 0 || b != 0) ? 1 : 0;
        if (op == "&&") return (a != 0 && b != 0) ? 1 : 0;
        if (op == "|") return static_cast<long long>(x | y);
        if (op == "^") return static_cast<long long>(x ^ y);
        if (op == "&") return static_cast<long long>(x & y);
        if (op == "==") return a == b ? 1 : 0;
        if (op == "!=") return a != b ? 1 : 0;
        if (op == "<") return a < b ? 1 : 0;
        if (op == ">") return a > b ? 1 : 0;
        if (op == "<=") return a <= b ? 1 : 0;
        if (op == ">=") return a >= b ? 1 : 0;
        if (op == "<<") return static_cast<long long>(x << (y & 63));
        if (op == ">>") return a >> (y & 63);
        if (op == "+") return static_cast<long long>(x + y);
        if (op == "-") return static_cast<long long>(x - y);
        if (op == "*") return static_cast<long long>(x * y);
        if (b == 0) return skipped_ > 0 ? 0 : fail("division by 0");
        if (b == -1) return op == "/" ? static_cast<long long>(0 - x) : 0;
        return op == "/" ? a / b : a % b;
    }

    long long unary() {
        if (++depth_ > kDeepestCondition) return fail("more than 200 expressions inside each other");
        if (at_ >= pieces_.size())
            return fail(pieces_.empty() ? "the condition is missing" : "a value is missing at the end");
        const Piece& piece = pieces_[at_++];
        const std::string_view text = piece.token.text;
        long long value = 0;
        if (text == "!") {
            value = unary() == 0 ? 1 : 0;
        } else if (text == "-") {
            value = static_cast<long long>(0 - static_cast<unsigned long long>(unary()));
        } else if (text == "+") {
            value = unary();
        } else if (text == "~") {
            value = ~unary();
        } else if (text == "(") {
            value = binary(0);
            if (peek() != ")") return fail("a ')' is missing");
            ++at_;
        } else if (piece.token.kind == TokenKind::word) {
            if (!result_.unknown && skipped_ == 0) result_.unknown = &piece;
        } else if (piece.token.kind != TokenKind::number || !readInteger(text, value)) {
            --at_;
            return fail(piece.token.kind == TokenKind::number
                            ? "'" + std::string(text) + "' is no whole number"
                            : "expected a value before '" + std::string(text) + "'");
        }
        --depth_;
        return value;
    }

    std::span<const Piece> pieces_;
    Condition result_;
    std::size_t at_ = 0;
    int depth_ = 0;
    int skipped_ = 0;  ///< more than 0 inside operands that are not needed
};

template <class... Base>
std::optional<double> parsed(std::string_view text, auto value, Base... base) {
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value, base...);
    if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return static_cast<double>(value);
}

}  // namespace

Condition evaluateCondition(std::span<const Piece> pieces) {
    return ConditionParser(pieces).run();
}

bool evaluateCondition(std::span<const ViewToken> tokens, long long& value) {
    std::vector<Piece> pieces(tokens.size());
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        pieces[i].token.text = tokens[i].text;
        pieces[i].token.kind = tokens[i].kind;
    }
    const Condition found = evaluateCondition(pieces);
    value = found.value;
    return found.error.empty();
}

int levelOf(std::string_view op) {
    struct Operator {
        std::string_view text;
        int level;
    };
    static constexpr Operator kOperators[] = {{"||", 1}, {"^^", 2}, {"&&", 3}, {"|", 4},  {"^", 5},
                                              {"&", 6},  {"==", 7}, {"!=", 7}, {"<", 8},  {">", 8},
                                              {"<=", 8}, {">=", 8}, {"<<", 9}, {">>", 9}, {"+", 10},
                                              {"-", 10}, {"*", 11}, {"/", 11}, {"%", 11}};
    for (const Operator& each : kOperators)
        if (each.text == op) return each.level;
    return 0;
}

bool readInteger(std::string_view text, long long& value) {
    const bool isHexadecimal = text.starts_with("0x") || text.starts_with("0X");
    const unsigned base = isHexadecimal ? 16 : (text.starts_with("0") ? 8 : 10);
    std::string_view digits = text.substr(isHexadecimal ? 2 : 0);
    if (digits.ends_with("u") || digits.ends_with("U")) digits.remove_suffix(1);
    if (digits.empty()) return false;
    unsigned long long number = 0;
    for (const char c : digits) {
        unsigned digit = base;
        if (c >= '0' && c <= '9') digit = static_cast<unsigned>(c - '0');
        if (c >= 'a' && c <= 'f') digit = static_cast<unsigned>(c - 'a') + 10;
        if (c >= 'A' && c <= 'F') digit = static_cast<unsigned>(c - 'A') + 10;
        if (digit >= base) return false;
        number = number * base + digit;
    }
    value = static_cast<long long>(number);
    return true;
}

std::optional<double> numberValue(std::string_view text) {
    const bool isHex = text.starts_with("0x") || text.starts_with("0X");
    while (!text.empty() && std::string_view(isHex ? "uU" : "uUfFlL").find(text.back()) != text.npos)
        text.remove_suffix(1);
    return isHex ? parsed(text.substr(2), 0ULL, 16) : parsed(text, 0.);
}

// ---- Directives

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
