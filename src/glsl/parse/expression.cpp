#include "glsl/parse/expression.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "glsl/parse/usage.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

constexpr int kDeepestExpression = 300;

struct Operator {
    std::string_view text;
    int level;
};
constexpr Operator kOperators[] = {{"||", 1}, {"^^", 2}, {"&&", 3}, {"|", 4},  {"^", 5},
                                   {"&", 6},  {"==", 7}, {"!=", 7}, {"<", 8},  {">", 8},
                                   {"<=", 8}, {">=", 8}, {"<<", 9}, {">>", 9}, {"+", 10},
                                   {"-", 10}, {"*", 11}, {"/", 11}, {"%", 11}};

Type typeOfNumber(std::string_view text) {
    const bool hex = text.starts_with("0x") || text.starts_with("0X");
    if (text.ends_with("lf") || text.ends_with("LF")) return scalarType(BaseType::doublePrecision);
    if (!hex && text.find_first_of(".eEfF") != std::string_view::npos) return scalarType(BaseType::floating);
    if (text.ends_with("u") || text.ends_with("U")) return scalarType(BaseType::unsignedInteger);
    return scalarType(BaseType::integer);
}

}  // namespace

void Expressions::markUses(Range range) {
    for (std::uint32_t i = range.first; i < range.end; ++i) {
        if (view_[i].kind != TokenKind::word) continue;
        WordRole role = WordRole::global;
        if (i > 0 && view_[i - 1].text == ".")
            role = WordRole::member;
        else if (names_.isLocal(view_[i].text))
            role = WordRole::local;
        else if (isType(view_[i]) && !names_.isKnown(view_[i].text))
            role = WordRole::other;
        bodies_.roles[i] = role;
    }
}

Type Expressions::typeOf(Range range) {
    markUses(range);
    return parse(range);
}

Type Expressions::parse(Range range) {
    if (range.empty()) return {};
    const auto saved = std::pair(at_, end_);
    at_ = range.first;
    end_ = range.end;
    Type type;
    // After something that is not understood, the rest is still searched for calls.
    while (at_ < end_) {
        type = assignment();
        if (at_ < end_ && !accept(",")) {
            ++at_;
            type = {};
        }
    }
    std::tie(at_, end_) = saved;
    return type;
}

std::string_view Expressions::peek(std::uint32_t ahead) const {
    return at_ + ahead < end_ ? view_[at_ + ahead].text : std::string_view{};
}

bool Expressions::accept(std::string_view text) {
    if (peek() != text) return false;
    ++at_;
    return true;
}

std::uint32_t Expressions::afterBracket() const {
    return std::min(std::min(matches_[at_], end_) + 1, end_);
}

Type Expressions::assignment() {
    if (depth_ > kDeepestExpression) {
        at_ = end_;
        return {};
    }
    ++depth_;
    Type type = binary(0);
    if (accept("?")) {
        const Type yes = assignment();
        const Type no = accept(":") ? assignment() : Type{};
        type = yes == no ? yes : Type{};
        if (yes.numeric() && no.numeric() && yes.columns == no.columns && yes.rows == no.rows)
            type = binaryType("+", yes, no);
    } else if (isAssignment(peek())) {
        ++at_;
        assignment();
    }
    --depth_;
    return type;
}

Type Expressions::binary(int lowest) {
    if (depth_ > kDeepestExpression) {
        at_ = end_;
        return {};
    }
    ++depth_;
    Type left = unary();
    while (at_ < end_) {
        const auto* const found = std::find_if(std::begin(kOperators), std::end(kOperators),
                                               [&](const Operator& each) { return each.text == peek(); });
        if (found == std::end(kOperators) || found->level <= lowest) break;
        const std::uint32_t op = at_++;
        const Type right = binary(found->level);
        const Type joined = binaryType(found->text, left, right);
        const bool compares = found->text == "==" || found->text == "!=";
        if (left.numeric() && right.numeric() &&
            (compares ? left.columns != right.columns || left.rows != right.rows : !joined.known()))
            bodies_.mismatches.push_back({op, left, right});
        left = joined;
    }
    --depth_;
    return left;
}

Type Expressions::unary() {
    // Prefix operators are read in a loop, because a source may contain a million of them in a row.
    bool logical = false;
    while (at_ < end_) {
        const std::string_view text = peek();
        if (text == "!")
            logical = true;
        else if (text != "-" && text != "+" && text != "~" && text != "++" && text != "--")
            break;
        ++at_;
    }
    const Type type = postfix();
    return logical ? scalarType(BaseType::boolean) : type;
}

Type Expressions::index(const Type& array) {
    const std::uint32_t close = std::min(matches_[at_], end_);
    parse({at_ + 1, close});
    at_ = std::min(close + 1, end_);
    Type type = array;
    if (type.arrayDepth > 0)
        --type.arrayDepth;
    else if (type.matrix())
        type = vectorType(type.base, type.rows);
    else if (type.vector())
        type = scalarType(type.base);
    else
        type = {};
    return type;
}

Type Expressions::postfix() {
    const std::uint32_t first = at_;
    Type type = primary();
    while (at_ < end_) {
        if (peek() == "[") {
            if (type.known()) bodies_.subscripts.push_back({{first, at_}, at_, type});
            type = index(type);
        } else if (peek() == "." && at_ + 1 < end_) {
            const std::uint32_t dot = at_++;
            const std::string_view member = peek();
            ++at_;
            if (type.scalar() && names_.memberType(type, member).known())
                bodies_.scalarSwizzles.push_back({{first, dot}, dot + 1, type});
            if (peek() == "(") {
                at_ = afterBracket();
                type = member == "length" ? scalarType(BaseType::integer) : Type{};
            } else {
                type = names_.memberType(type, member);
            }
        } else if (peek() == "++" || peek() == "--") {
            ++at_;
        } else {
            break;
        }
    }
    return type;
}

Type Expressions::primary() {
    if (at_ >= end_) return {};
    const ViewToken& token = view_[at_];
    if (token.kind == TokenKind::number) {
        ++at_;
        return typeOfNumber(token.text);
    }
    if (token.text == "(" || token.text == "{") {
        const std::uint32_t close = std::min(matches_[at_], end_);
        if (depth_ > kDeepestExpression) {
            at_ = std::min(close + 1, end_);
            return {};
        }
        ++depth_;
        const Type inside = parse({at_ + 1, close});
        --depth_;
        at_ = std::min(close + 1, end_);
        return token.text == "(" ? inside : Type{};
    }
    if (token.kind != TokenKind::word) return {};
    const std::uint32_t name = at_++;
    if (token.text == "true" || token.text == "false") return scalarType(BaseType::boolean);
    if (token.text == "const") {
        while (accept("const")) {
        }
        return primary();
    }
    if (peek() == "(") return call(name);
    if (peek() == "[" && !names_.isKnown(token.text) && (isType(token) || names_.isStructure(token.text))) {
        // vec3[2](a, b)
        std::uint16_t depth = 0;
        while (peek() == "[") {
            parse({at_ + 1, std::min(matches_[at_], end_)});
            at_ = afterBracket();
            ++depth;
        }
        Type type = peek() == "(" ? call(name) : Type{};
        type.arrayDepth = depth;
        return type;
    }
    return names_.typeOfName(token.text);
}

Type Expressions::call(std::uint32_t name) {
    Call result;
    result.name = name;
    const std::uint32_t open = at_;
    const std::uint32_t close = std::min(matches_[open], end_);
    std::uint32_t start = open + 1;
    if (depth_ > kDeepestExpression) {
        at_ = std::min(close + 1, end_);
        return {};
    }
    ++depth_;
    const auto saved = end_;
    end_ = close;
    at_ = start;
    while (at_ < end_) {
        const Type type = assignment();
        // If tokens before the next comma were not understood, the type of the argument is unknown.
        const bool whole = at_ >= end_ || peek() == ",";
        while (at_ < end_ && peek() != ",") {
            const bool bracket = opensBracket(peek());
            at_ = bracket ? afterBracket() : at_ + 1;
        }
        result.arguments.push_back({start, at_});
        result.types.push_back(whole ? type : Type{});
        if (!accept(",")) break;
        start = at_;
    }
    end_ = saved;
    at_ = std::min(close + 1, end_);
    --depth_;
    const std::string_view function = view_[name].text;
    Type type;
    if (names_.isFunction(function))
        type = names_.returnType(function, result.types);
    else if (names_.isStructure(function))
        type = names_.typeOfStructure(function);
    else
        type = callType(function, result.types);
    if (!isType(view_[name])) bodies_.calls.push_back(std::move(result));
    return type;
}

}  // namespace glibra::glsl
