#include "glsl/facts/formula.h"

#include <charconv>

#include "glsl/parse/usage.h"

namespace glibra::glsl {
namespace {

constexpr int kDeepestFormula = 24;
constexpr std::size_t kMostTokens = 2'000'000;  // per stage

bool isScalarType(std::string_view word) {
    return word == "int" || word == "uint" || word == "float" || word == "double";
}

template <class... Base>
std::optional<double> parsed(std::string_view text, auto value, Base... base) {
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value, base...);
    if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return static_cast<double>(value);
}

/// The value of a literal: "12u", "0x1F", "1.5e3", "2.lf".
std::optional<double> numberOf(std::string_view text) {
    const bool isHex = text.starts_with("0x") || text.starts_with("0X");
    while (!text.empty() && std::string_view(isHex ? "uU" : "uUfFlL").find(text.back()) != text.npos)
        text.remove_suffix(1);
    return isHex ? parsed(text.substr(2), 0ULL, 16) : parsed(text, 0.);
}

}  // namespace

bool TokenSearch::opens(std::uint32_t at) const {
    return text(at) == "(" || text(at) == "[" || text(at) == "{";
}

bool TokenSearch::spend(std::size_t tokens) {
    spent_ += tokens;
    return spent_ < kMostTokens;
}

std::vector<Range> TokenSearch::parts(Range range, std::string_view separator) const {
    std::vector<Range> result;
    std::uint32_t start = range.first;
    for (std::uint32_t at = range.first; at < range.end; ++at) {
        if (opens(at) && match(at) < range.end) at = match(at);
        if (text(at) != separator) continue;
        result.push_back({start, at});
        start = at + 1;
    }
    result.push_back({start, range.end});
    return result;
}

bool TokenSearch::isChange(std::string_view name, std::uint32_t at) const {
    return text(at) == name && unit_.bodies.roles[at] != WordRole::member && isWrittenAt(unit_, at);
}

bool TokenSearch::changes(std::string_view name, Range range) {
    if (range.empty()) return false;
    if (!spend(range.end - range.first)) return true;
    for (std::uint32_t at = range.first; at < range.end; ++at)
        if (isChange(name, at)) return true;
    return false;
}

std::optional<Formula> TokenSearch::formula(Range range) {
    Formula result;
    std::uint32_t at = range.first;
    const bool isKnown = ++depth_ <= kDeepestFormula && !range.empty() && spend(range.end - range.first) &&
                         sum(at, range.end, result) && at == range.end;
    --depth_;
    return isKnown ? std::optional(std::move(result)) : std::nullopt;
}

bool TokenSearch::append(Range range, Formula& to) {
    const std::optional<Formula> part = formula(range);
    if (part) to.steps.insert(to.steps.end(), part->steps.begin(), part->steps.end());
    return part.has_value();
}

bool TokenSearch::sum(std::uint32_t& at, std::uint32_t end, Formula& to) {
    if (!product(at, end, to)) return false;
    while (at < end && (text(at) == "+" || text(at) == "-")) {
        const Operation operation = text(at) == "+" ? Operation::add : Operation::subtract;
        if (!product(++at, end, to)) return false;
        to.steps.emplace_back(operation);
    }
    return true;
}

bool TokenSearch::product(std::uint32_t& at, std::uint32_t end, Formula& to) {
    if (!operand(at, end, to)) return false;
    while (at < end && (text(at) == "*" || text(at) == "/")) {
        const Operation operation = text(at) == "*" ? Operation::multiply : Operation::divide;
        if (!operand(++at, end, to)) return false;
        to.steps.emplace_back(operation);
    }
    return true;
}

bool TokenSearch::operand(std::uint32_t& at, std::uint32_t end, Formula& to) {
    bool isNegative = false;
    while (at < end && (text(at) == "-" || text(at) == "+")) isNegative ^= text(at++) == "-";
    if (at >= end || !primary(at, end, to)) return false;
    if (isNegative) to.steps.emplace_back(Operation::negate);
    return true;
}

bool TokenSearch::primary(std::uint32_t& at, std::uint32_t end, Formula& to) {
    const std::uint32_t here = at++;
    if (unit_.view[here].kind == TokenKind::number) {
        const std::optional<double> value = numberOf(text(here));
        if (value) to.steps.emplace_back(*value);
        return value.has_value();
    }
    if (text(here) == "(" && match(here) < end) {
        at = match(here) + 1;
        return append({here + 1, match(here)}, to);
    }
    if (!isWord(here)) return false;
    if (text(at) == "(" && match(at) < end) {
        const Range inside{at + 1, match(at)};
        at = match(at) + 1;
        return call(text(here), inside, to);
    }
    const bool isPart = at < end && (text(at) == "[" || text(at) == ".");
    return !isPart && name(here, to);
}

bool TokenSearch::call(std::string_view function, Range inside, Formula& to) {
    if (isScalarType(function)) {
        if (!append(inside, to)) return false;
        if (function == "int" || function == "uint") to.steps.emplace_back(Operation::truncate);
        return true;
    }
    const std::vector<Range> arguments = parts(inside, ",");
    if ((function != "min" && function != "max") || arguments.size() != 2) return false;
    if (!append(arguments[0], to) || !append(arguments[1], to)) return false;
    to.steps.emplace_back(function == "min" ? Operation::least : Operation::greatest);
    return true;
}

/// A uniform, or a variable that keeps the value of its declaration.
bool TokenSearch::name(std::uint32_t at, Formula& to) {
    if (!spend(unit_.bodies.locals.size() + unit_.variables.size())) return false;
    if (unit_.bodies.roles[at] == WordRole::local) return local(at, to);
    for (const Variable& each : unit_.variables) {
        if (each.name != text(at) || each.isArray() || !isScalarType(each.type)) continue;
        if (each.storage == Storage::uniform) {
            to.steps.emplace_back(each.name);
            return true;
        }
        const Range initializer =
            unit_.syntax.declarations[each.declaration].declarators[each.declarator].initializer;
        const bool isKept = each.storage == Storage::constant ||
                            (each.storage == Storage::none && !unit_.isWritten(each.name));
        return isKept && append(initializer, to);
    }
    return false;
}

bool TokenSearch::local(std::uint32_t at, Formula& to) {
    const LocalVariable* found = nullptr;
    for (const LocalVariable& each : unit_.bodies.locals) {
        if (text(each.name) != text(at)) continue;
        if (found != nullptr) return false;
        found = &each;
    }
    if (found == nullptr || found->isParameter) return false;
    // The declaration itself counts as a change, so the text before and after it is searched.
    const bool isKept = !changes(text(at), {0, found->name}) &&
                        !changes(text(at), {found->name + 1, static_cast<std::uint32_t>(unit_.view.size())});
    return isKept && append(found->initializer, to);
}

}  // namespace glibra::glsl
