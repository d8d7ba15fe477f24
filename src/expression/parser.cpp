#include "expression/parser.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/text.h"
#include "expression/functions.h"

namespace glibra::expression {

void Builder::emit(Instruction instruction, Range range, std::size_t removed, std::size_t added) {
    instruction.isChecked = unchecked == 0;
    code_.instructions.push_back(instruction);
    code_.ranges.push_back({range.begin + textBegin, range.end + textBegin});
    depth_ = depth_ - removed + added;
    highest_ = std::max(highest_, depth_);
    steps_ = std::max(steps_, code_.instructions.size());
}

Operand Builder::pushed(std::span<const double> values, Type type, Range range) {
    Instruction push;
    push.op = Op::push;
    push.target = static_cast<std::uint32_t>(code_.constants.size());
    push.n = static_cast<std::uint8_t>(values.size());
    code_.constants.insert(code_.constants.end(), values.begin(), values.end());
    Operand operand{.type = type, .range = range, .begin = end(), .isConstant = true};
    emit(push, range, 0, values.size());
    return operand;
}

Operand Builder::combined(std::span<const Operand> from, Instruction instruction, Type type, Range range) {
    Operand result{.type = type, .range = range, .begin = from.front().begin};
    std::size_t removed = 0;
    bool isConstant = true;
    for (const Operand& each : from) {
        removed += each.type.size();
        isConstant = isConstant && each.isConstant;
    }
    emit(instruction, range, removed, type.size());
    result.isConstant = isConstant && fold(result.begin);
    return result;
}

std::span<const double> Builder::valueOf(const Operand& operand) const {
    const Instruction& push = code_.instructions[operand.begin];
    return {code_.constants.data() + push.target, push.n};
}

void Builder::setValue(const Operand& operand, double value) {
    code_.constants[code_.instructions[operand.begin].target] = value;
}

/// Replaces the instructions from `first` on, which begin with a push, by a push of their result. False if
/// the result is a problem, which is then reported whenever the code is run.
bool Builder::fold(std::size_t first) {
    if (!isWithinLimits()) return false;
    double stack[kMostDoubles];
    if (run(code_, first, nullptr, stack)) return false;
    const std::size_t size = code_.instructions.back().n;
    const Range range = code_.ranges.back();
    Instruction push = code_.instructions[first];
    push.n = static_cast<std::uint8_t>(size);
    code_.constants.resize(push.target);
    code_.constants.insert(code_.constants.end(), stack, stack + size);
    code_.instructions.resize(first);
    code_.ranges.resize(first);
    code_.instructions.push_back(push);
    code_.ranges.push_back(range);
    return true;
}

std::size_t Builder::emitJump(Op op, Range range, std::size_t removed) {
    Instruction jump;
    jump.op = op;
    emit(jump, range, removed, 0);
    return end() - 1;
}

void Builder::jumpHere(std::size_t jump) {
    code_.instructions[jump].target = static_cast<std::uint32_t>(end() - jump - 1);
}

void Builder::erase(std::size_t first, std::size_t last, std::size_t numbers) {
    const auto from = static_cast<std::ptrdiff_t>(first);
    const auto to = static_cast<std::ptrdiff_t>(last);
    code_.instructions.erase(code_.instructions.begin() + from, code_.instructions.begin() + to);
    code_.ranges.erase(code_.ranges.begin() + from, code_.ranges.begin() + to);
    depth_ -= numbers;
}

std::size_t Builder::use(std::string_view path, Symbol symbol) {
    // In a body a name may mean something else than in the text.
    const auto found = std::ranges::find_if(
        code_.uses, [&](const Use& each) { return each.path == path && each.symbol.slot == symbol.slot; });
    if (found != code_.uses.end()) return static_cast<std::size_t>(found - code_.uses.begin());
    code_.uses.push_back({std::string(path), std::move(symbol)});
    return code_.uses.size() - 1;
}

void Builder::finishUses() {
    constexpr std::size_t kUnread = static_cast<std::size_t>(-1);
    std::vector<std::size_t> places(code_.uses.size(), kUnread);
    std::vector<Use> read;
    for (Instruction& each : code_.instructions) {
        if (each.op != Op::load && each.op != Op::loadAt) continue;
        std::size_t& place = places[each.target];
        if (place == kUnread) {
            place = read.size();
            read.push_back(std::move(code_.uses[each.target]));
            code_.depends = code_.depends | read.back().symbol.depends;
        }
        each.target = static_cast<std::uint32_t>(place);
    }
    code_.uses = std::move(read);
}

namespace {

using base::isDigit;

constexpr std::string_view kNoBreakSpace = "\xc2\xa0";

bool isHexDigit(char c) {
    return isDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}
bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\n' || c == '\r';
}

/// Signs of two bytes come first.
constexpr std::string_view kSigns[] = {"<=", ">=", "==", "!=", "&&", "||", "^^", "<<", ">>", "+",
                                       "-",  "*",  "/",  "%",  "<",  ">",  "!",  "~",  "&",  "|",
                                       "^",  "?",  ":",  "(",  ")",  "[",  "]",  ",",  "."};

/// How many bytes from `at` on satisfy the condition.
template <class Condition>
std::size_t countWhile(std::string_view text, std::size_t at, const Condition& condition) {
    std::size_t end = at;
    while (end < text.size() && condition(text[end])) ++end;
    return end - at;
}

/// For a decimal number without sign that no double can hold: true if it is too large, false if it is too
/// small.
bool isAboveOne(std::string_view decimal) {
    constexpr long kFar = 1'000'000;
    const std::size_t mantissa = std::min(decimal.find_first_of("eE"), decimal.size());
    const std::size_t point = std::min(decimal.find('.'), mantissa);
    const std::size_t first = decimal.find_first_of("123456789");
    if (first >= mantissa) return false;
    long exponent = 0;
    if (mantissa < decimal.size()) {
        const bool isNegative = decimal[mantissa + 1] == '-';
        const char* const digits = decimal.data() + mantissa + (decimal[mantissa + 1] == '+' ? 2 : 1);
        if (std::from_chars(digits, decimal.data() + decimal.size(), exponent).ec != std::errc())
            exponent = isNegative ? -kFar : kFar;
    }
    return static_cast<long>(point) - static_cast<long>(first) + exponent > 0;
}

}  // namespace

Token Lexer::token(TokenKind kind, std::size_t length) const {
    Token token;
    token.kind = kind;
    token.text = text_.substr(at_, length);
    token.range = {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + token.text.size())};
    return token;
}

Token Lexer::wrong(std::size_t length, const char* why) const {
    Token wrong = token(TokenKind::wrong, length);
    wrong.why = why;
    return wrong;
}

void Lexer::skipBlanks() {
    while (at_ < text_.size()) {
        const std::string_view rest = text_.substr(at_);
        if (isBlank(rest[0])) {
            ++at_;
        } else if (rest.starts_with(kNoBreakSpace)) {
            at_ += kNoBreakSpace.size();
        } else if (rest[0] == '#' || rest.starts_with("//")) {
            at_ += countWhile(rest, 0, [](char c) { return c != '\n' && c != '\r'; });
        } else if (rest[0] == '\\') {
            // Joins two lines if only blanks and a comment follow it.
            const std::size_t next = 1 + countWhile(rest, 1, [](char c) { return c == ' ' || c == '\t'; });
            const std::string_view after = rest.substr(next);
            if (!after.starts_with('\n') && !after.starts_with('\r') && !after.starts_with('#') &&
                !after.starts_with("//"))
                return;
            at_ += next;
        } else {
            return;
        }
    }
}

Token Lexer::number() {
    const std::string_view rest = text_.substr(at_);
    const bool isHex =
        rest.size() > 2 && rest[0] == '0' && (rest[1] == 'x' || rest[1] == 'X') && isHexDigit(rest[2]);
    std::size_t end = 0;
    double value = 0;
    if (isHex) {
        end = 2 + countWhile(rest, 2, isHexDigit);
        std::uint64_t whole = 0;
        const auto read = std::from_chars(rest.data() + 2, rest.data() + end, whole, 16);
        if (read.ec != std::errc() || whole > (std::uint64_t{1} << 53U))
            return wrong(end, "a hexadecimal number is at most 2^53");
        value = static_cast<double>(whole);
    } else {
        end = countWhile(rest, 0, isDigit);
        if (end < rest.size() && rest[end] == '.') end += 1 + countWhile(rest, end + 1, isDigit);
        if (end < rest.size() && (rest[end] == 'e' || rest[end] == 'E')) {
            const std::size_t digits =
                end + (end + 1 < rest.size() && (rest[end + 1] == '+' || rest[end + 1] == '-') ? 2 : 1);
            const std::size_t count = countWhile(rest, digits, isDigit);
            if (count > 0) end = digits + count;
        }
        const auto read = std::from_chars(rest.data(), rest.data() + end, value);
        if (read.ec == std::errc::result_out_of_range) {
            if (isAboveOne(rest.substr(0, end))) return wrong(end, "the number is too large");
            value = 0;
        }
    }
    // Suffixes of GLSL mean nothing here.
    std::size_t suffix = 0;
    for (const std::string_view each : {"lf", "LF", "f", "F", "u", "U"})
        if (suffix == 0 && rest.substr(end).starts_with(each)) suffix = each.size();
    const std::size_t more = countWhile(rest, end + suffix, base::isOfName);
    if (more > 0) return wrong(end + suffix + more, "this is neither a number nor a name");
    Token number = token(TokenKind::number, end + suffix);
    number.number = value;
    return number;
}

Token Lexer::next() {
    skipBlanks();
    if (at_ >= text_.size()) return token(TokenKind::end, 0);
    const std::string_view rest = text_.substr(at_);
    Token result;
    if (isDigit(rest[0]) || (rest.size() > 1 && rest[0] == '.' && isDigit(rest[1]))) {
        result = number();
    } else if (base::beginsName(rest[0])) {
        result = token(TokenKind::name, countWhile(rest, 0, base::isOfName));
    } else {
        for (const std::string_view sign : kSigns)
            if (result.kind == TokenKind::end && rest.starts_with(sign))
                result = token(TokenKind::sign, sign.size());
        if (result.kind == TokenKind::end) {
            // A character of UTF-8 is shown whole.
            const std::size_t length = 1 + countWhile(rest, 1, [](char c) {
                                           return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
                                       });
            result = wrong(rest[0] == '=' ? 1 : length,
                           rest[0] == '=' ? "nothing can be assigned here; '==' compares"
                                          : "this character is not part of the syntax of expressions");
        }
    }
    at_ += result.text.size();
    return result;
}

std::string_view article(std::string_view noun) {
    return std::string_view("aeiou").find(noun.empty() ? 'x' : noun.front()) == std::string_view::npos ? "a"
                                                                                                       : "an";
}

std::string joined(std::span<const std::string> words, std::string_view last) {
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (k > 0) text += k + 1 == words.size() ? last : std::string_view(", ");
        text += words[k];
    }
    return text;
}

std::optional<Problem> Parser::parse() {
    if (token_.kind == TokenKind::end) {
        problem({0, static_cast<std::uint32_t>(code_.text.size())}, "expr-E01", "the expression is empty");
        return std::move(problem_);
    }
    if (auto result = expression(); result && !problem_) {
        if (token_.kind != TokenKind::end)
            unexpected("an operator or the end of the expression");
        else
            finish(*result);
    }
    return std::move(problem_);
}

std::nullopt_t Parser::problem(Range range, const char* id, std::string text) {
    const std::uint32_t begin = build_.textBegin;
    if (!problem_) problem_ = problemAt(code_, {range.begin + begin, range.end + begin}, id, std::move(text));
    return std::nullopt;
}

std::nullopt_t Parser::unexpected(std::string_view expected) {
    if (token_.kind == TokenKind::wrong)
        return problem(token_.range, "expr-E01",
                       fmt::format("{}: {}", quoted(text_, token_.range), token_.why));
    return problem(token_.range, "expr-E01",
                   fmt::format("expected {}, found {}{}", expected,
                               token_.kind == TokenKind::end ? std::string("the end of the expression")
                                                             : quoted(text_, token_.range),
                               token_.text == "at" ? "; a time may stand after sum, mean, least and largest "
                                                     "alone: sum(NAME) at 2"
                                                   : ""));
}

std::nullopt_t Parser::tooDeep() {
    return problem(token_.range, "expr-E05",
                   fmt::format("more than {} levels of parentheses, signs or conditions", limits_.depth));
}

Parser::Parsed Parser::withinLimits(Parsed operand) {
    if (operand && !build_.isWithinLimits())
        return problem({0, static_cast<std::uint32_t>(text_.size())}, "expr-E05",
                       "the expression is too long, or holds too many values at once");
    return operand;
}

void Parser::take() {
    lastEnd_ = token_.range.end;
    token_ = lexer_.next();
}

bool Parser::takeIf(std::string_view sign) {
    if (!token_.is(sign)) return false;
    take();
    return true;
}

Range Parser::since(std::uint32_t begin) const {
    return {begin, lastEnd_};
}

std::string_view Parser::textOf(Range range) const {
    return text_.substr(range.begin, range.end - range.begin);
}

bool Parser::wants(const Type& type) const {
    return std::ranges::find(wanted_.types, type) != wanted_.types.end();
}

void Parser::finish(Operand result) {
    if (!settle(result)) return;
    if (result.choice && wants(Type::word()) && !wants(Type::number())) wordOfChoice(result);
    const bool accepted = wanted_.types.empty() ? result.type.kind != Kind::word : wants(result.type);
    if (!accepted && !problem_) {
        std::vector<std::string> accepts;
        for (const Type& each : wanted_.types)
            if (each == Type::word())
                accepts.insert(accepts.end(), wanted_.words.begin(), wanted_.words.end());
            else
                accepts.push_back(name(each));
        if (accepts.empty()) accepts.emplace_back("number");
        problem(result.range, "expr-E03",
                fmt::format("expected {}, found {}", joined(accepts, " or "), name(result.type)));
    }
    if (problem_) return;
    code_.type = result.type;
    build_.finishUses();
    code_.instructions.shrink_to_fit();
    code_.ranges.shrink_to_fit();
}

void Parser::wordOfChoice(Operand& result) {
    std::vector<double> places;
    for (const std::string& each : code_.uses[*result.choice].symbol.words) {
        const auto found = std::ranges::find(wanted_.words, each);
        if (found == wanted_.words.end()) {
            problem(result.range, "expr-E03",
                    fmt::format("{} may be '{}'; expected {}", code_.uses[*result.choice].path, each,
                                joined(std::vector<std::string>(wanted_.words.begin(), wanted_.words.end()),
                                       " or ")));
            return;
        }
        places.push_back(static_cast<double>(found - wanted_.words.begin()));
    }
    Instruction word;
    word.op = Op::word;
    word.target = static_cast<std::uint32_t>(code_.constants.size());
    word.b = static_cast<std::uint8_t>(places.size());
    code_.constants.insert(code_.constants.end(), places.begin(), places.end());
    build_.emit(word, result.range, 1, 1);
    result.type = Type::word();
}

Checked<Expression> parse(std::string_view text, const Place& origin, const Names& names,
                          const Wanted& wanted, const Limits& limits) {
    auto code = std::make_shared<Code>();
    code->origin = origin;
    if (text.size() > limits.bytes)
        return problemAt(*code, {}, "expr-E05",
                         fmt::format("expression of {} bytes; the limit is {}", text.size(), limits.bytes));
    code->text = text;
    if (auto problem = Parser(*code, names, wanted, limits).parse()) return std::move(*problem);
    return Expression(std::move(code));
}

std::optional<Problem> problemOf(const Function& function, const Names& names) {
    std::optional<Problem> first;
    const auto shared = std::make_shared<const Function>(function);
    for (const Type type : {Type::number(), Type::vector(3), Type::vector(4), Type::vector(2),
                            Type::matrix(4), Type::boolean(), Type::matrix(3), Type::matrix(2)}) {
        Code code;
        code.origin = function.origin;
        code.text = function.body;
        const std::vector<Type> types(function.parameters.size(), type);
        auto problem = Parser(code, names, {}, {}).parseBody(shared, types);
        if (!problem) return std::nullopt;
        // A problem that the types decide is one of the calls.
        const bool isSame = !first || (first->message.id == problem->message.id &&
                                       first->message.text == problem->message.text);
        if (!isSame) return std::nullopt;
        first = std::move(problem);
        if (types.empty()) break;
    }
    return first;
}

}  // namespace glibra::expression
