#include "glsl/facts/formula.h"

#include <algorithm>
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
    return opensBracket(text(at));
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
    if (at = here; measure(at, end, to)) return true;
    at = here + 1;
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

const LocalVariable* TokenSearch::keptLocal(std::uint32_t at) {
    const LocalVariable* found = unit_.onlyLocal(text(at));
    if (found == nullptr || found->isParameter || found->initializer.empty()) return nullptr;
    // The declaration itself counts as a change, so the text before and after it is searched.
    const bool isKept = !changes(text(at), {0, found->name}) &&
                        !changes(text(at), {found->name + 1, static_cast<std::uint32_t>(unit_.view.size())});
    return isKept ? found : nullptr;
}

bool TokenSearch::local(std::uint32_t at, Formula& to) {
    const LocalVariable* found = keptLocal(at);
    return found != nullptr && append(found->initializer, to);
}

std::string TokenSearch::sizeCall(Range range) {
    const bool isImage = text(range.first) == "imageSize";
    if ((!isImage && text(range.first) != "textureSize") || text(range.first + 1) != "(" ||
        match(range.first + 1) + 1 != range.end)
        return {};
    const std::vector<Range> arguments = parts({range.first + 2, range.end - 1}, ",");
    if (arguments.front().end != arguments.front().first + 1 || arguments.size() > (isImage ? 1U : 2U))
        return {};
    const std::string object(text(arguments.front().first));
    if (isImage) return "imageSize(" + object + ")";
    std::string level = "0";
    if (arguments.size() == 2) {
        const bool isNumber = arguments[1].end == arguments[1].first + 1 &&
                              unit_.view[arguments[1].first].kind == TokenKind::number;
        if (!isNumber) return {};
        level = text(arguments[1].first);
    }
    return "textureSize(" + object + ", " + level + ")";
}

bool TokenSearch::measure(std::uint32_t& at, std::uint32_t end, Formula& to) {
    const std::uint32_t here = at;
    std::uint32_t after = here + 1;
    std::string size;
    if (text(after) == "(" && match(after) < end) {
        after = match(after) + 1;
        size = sizeCall({here, after});
        if (size.empty()) return false;
    } else if (unit_.bodies.roles[here] == WordRole::local && text(after) == ".") {
        const LocalVariable* found = keptLocal(here);
        if (found == nullptr) return false;
        size = sizeCall(found->initializer);
        if (size.empty()) return false;
    }
    if (!size.empty()) {
        std::string_view component = "x";
        if (text(after) == "." && after + 1 < end) {
            component = text(after + 1);
            after += 2;
        }
        constexpr std::string_view kNames = "xyzwrgbastpq";
        const std::size_t axis = component.size() == 1 ? kNames.find(component) : std::string_view::npos;
        if (axis == std::string_view::npos) return false;
        at = after;
        to.steps.emplace_back(size + "." + "xyz"[std::min<std::size_t>(axis % 4, 2)]);
        return true;
    }
    if (unit_.bodies.roles[here] != WordRole::global || text(after) == "[") return false;
    const auto isBlockName = [&](std::string_view name, bool asInstance) {
        for (const Declaration& each : unit_.syntax.declarations) {
            if (each.kind != DeclarationKind::block ||
                (each.qualifiers.storage != Storage::uniform && each.qualifiers.storage != Storage::buffer))
                continue;
            if (asInstance && !each.declarators.empty() && text(each.declarators.front().name) == name)
                return true;
            if (asInstance || !each.declarators.empty()) continue;
            for (const Declaration& member : each.members)
                for (const Declarator& one : member.declarators)
                    if (text(one.name) == name) return true;
        }
        return false;
    };
    std::string name(text(here));
    if (isBlockName(name, true)) {
        if (text(after) != "." || after + 1 >= end || !isWord(after + 1)) return false;
        name += "." + std::string(text(after + 1));
        after += 2;
    } else if (!isBlockName(name, false)) {
        return false;
    }
    if (text(after) == "[") return false;
    if (text(after) == ".") {
        if (text(after + 1) != "length" || text(after + 2) != "(" || text(after + 3) != ")" ||
            after + 4 > end)
            return false;
        name += ".length()";
        after += 4;
    }
    at = after;
    to.steps.emplace_back(std::move(name));
    return true;
}

}  // namespace glibra::glsl
