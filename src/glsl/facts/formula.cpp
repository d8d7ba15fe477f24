#include "glsl/facts/formula.h"

#include <algorithm>

#include "glsl/parse/usage.h"
#include "glsl/read/preprocessor.h"

namespace glibra::glsl {
namespace {

constexpr int kDeepestFormula = 24;
constexpr std::size_t kMostTokens = 2'000'000;  // per stage

bool isScalarType(std::string_view word) {
    return word == "int" || word == "uint" || word == "float" || word == "double";
}

}  // namespace

bool FormulaSearch::spend(std::size_t tokens) {
    spent_ += tokens;
    return spent_ < kMostTokens;
}

bool FormulaSearch::isChange(std::string_view name, std::uint32_t at) const {
    return text(at) == name && unit_.bodies.roles[at] != WordRole::member && isWrittenAt(unit_, at);
}

bool FormulaSearch::changes(std::string_view name, Range range) {
    if (range.empty()) return false;
    if (!spend(range.end - range.first)) return true;
    for (std::uint32_t at = range.first; at < range.end; ++at)
        if (isChange(name, at)) return true;
    return false;
}

std::optional<Formula> FormulaSearch::formula(std::uint32_t expression, bool skipsFirst) {
    Formula result;
    const bool isKnown = ++depth_ <= kDeepestFormula && expression != kNone &&
                         spend(node(expression).end - node(expression).first) &&
                         add(expression, result, skipsFirst);
    --depth_;
    return isKnown ? std::optional(std::move(result)) : std::nullopt;
}

bool FormulaSearch::append(std::uint32_t expression, Formula& to) {
    const std::optional<Formula> part = formula(expression);
    if (part) to.steps.insert(to.steps.end(), part->steps.begin(), part->steps.end());
    return part.has_value();
}

bool FormulaSearch::add(std::uint32_t expression, Formula& to, bool skipsFirst) {
    const Node& it = node(expression);
    switch (it.kind) {
        case NodeKind::number: {
            const std::optional<double> value = numberValue(text(it.token));
            if (value) to.steps.emplace_back(*value);
            return value.has_value();
        }
        case NodeKind::group:
            return append(it.child, to);
        case NodeKind::prefix:
            return prefix(it, to);
        case NodeKind::chain:
            return chain(expression, to, skipsFirst);
        case NodeKind::call:
            return measure(expression, to) || call(it, to);
        case NodeKind::name:
            return measure(expression, to) || name(it.token, to);
        case NodeKind::member:
        case NodeKind::method:
            return measure(expression, to);
        default:
            return false;
    }
}

bool FormulaSearch::chain(std::uint32_t expression, Formula& to, bool skipsFirst) {
    constexpr std::string_view kSigns = "+-*/";
    bool isFirst = true;
    for (const std::uint32_t each : unit_.bodies.children(expression)) {
        const bool isSkipped = skipsFirst && each == node(expression).child;
        if (!isSkipped && !add(each, to, false)) return false;
        if (!isFirst && !isSkipped) {
            const std::string_view sign = text(node(each).first - 1);
            const std::size_t which = kSigns.find(sign);
            if (sign.size() != 1 || which == std::string_view::npos) return false;
            to.steps.emplace_back(static_cast<Operation>(which));
        }
        isFirst = isFirst && isSkipped;
    }
    return true;
}

bool FormulaSearch::prefix(const Node& expression, Formula& to) {
    bool isNegative = false;
    for (std::uint32_t at = expression.first; at < node(expression.child).first; ++at) {
        if (text(at) != "-" && text(at) != "+") return false;
        isNegative ^= text(at) == "-";
    }
    if (!add(expression.child, to, false)) return false;
    if (isNegative) to.steps.emplace_back(Operation::negate);
    return true;
}

bool FormulaSearch::call(const Node& call, Formula& to) {
    const std::string_view function = text(call.token);
    if (call.child == kNone) return false;
    const std::uint32_t second = node(call.child).next;
    if (isScalarType(function)) {
        if (second != kNone || !append(call.child, to)) return false;
        if (function == "int" || function == "uint") to.steps.emplace_back(Operation::truncate);
        return true;
    }
    if ((function != "min" && function != "max") || second == kNone || second != call.lastChild) return false;
    if (!append(call.child, to) || !append(second, to)) return false;
    to.steps.emplace_back(function == "min" ? Operation::least : Operation::greatest);
    return true;
}

/// A uniform, or a variable that keeps the value of its declaration.
bool FormulaSearch::name(std::uint32_t at, Formula& to) {
    if (!spend(unit_.bodies.locals.size() + unit_.variables.size())) return false;
    if (unit_.bodies.roles[at] == WordRole::local) {
        const LocalVariable* found = keptLocal(at);
        return found != nullptr && append(found->value, to);
    }
    for (const Variable& each : unit_.variables) {
        if (each.name != text(at) || each.isArray() || !isScalarType(each.type)) continue;
        if (each.storage == Storage::uniform) {
            to.steps.emplace_back(each.name);
            return true;
        }
        const bool isKept = each.storage == Storage::constant ||
                            (each.storage == Storage::none && !unit_.isWritten(each.name));
        return isKept &&
               append(unit_.syntax.declarations[each.declaration].declarators[each.declarator].value, to);
    }
    return false;
}

const LocalVariable* FormulaSearch::keptLocal(std::uint32_t at) {
    const LocalVariable* found = unit_.onlyLocal(text(at));
    if (found == nullptr || found->isParameter || found->initializer.empty()) return nullptr;
    // The declaration itself counts as a change, so the text before and after it is searched.
    const bool isKept = !changes(text(at), {0, found->name}) &&
                        !changes(text(at), {found->name + 1, static_cast<std::uint32_t>(unit_.view.size())});
    return isKept ? found : nullptr;
}

std::string FormulaSearch::sizeCall(std::uint32_t expression) const {
    const Node& call = node(expression);
    const std::string_view function = text(call.token);
    const bool isImage = function == "imageSize";
    if (call.kind != NodeKind::call || (!isImage && function != "textureSize") || call.child == kNone)
        return {};
    const Node& object = node(call.child);
    if (object.end != object.first + 1 || (isImage && object.next != kNone)) return {};
    const std::string name = std::string(function) + "(" + std::string(text(object.first));
    if (isImage) return name + ")";
    if (object.next == kNone) return name + ", 0)";
    const Node& level = node(object.next);
    if (level.kind != NodeKind::number || level.next != kNone) return {};
    return name + ", " + std::string(text(level.token)) + ")";
}

bool FormulaSearch::isBlockName(std::string_view name, bool asInstance) const {
    const auto isIt = [&](const Declarator& each) { return text(each.name) == name; };
    return std::ranges::any_of(unit_.syntax.declarations, [&](const Declaration& each) {
        if (each.kind != DeclarationKind::block ||
            (each.qualifiers.storage != Storage::uniform && each.qualifiers.storage != Storage::buffer))
            return false;
        if (!each.declarators.empty()) return asInstance && isIt(each.declarators.front());
        return !asInstance && std::ranges::any_of(each.members, [&](const Declaration& member) {
            return std::ranges::any_of(member.declarators, isIt);
        });
    });
}

bool FormulaSearch::measure(std::uint32_t expression, Formula& to) {
    const Node& it = node(expression);
    const bool isMember = it.kind == NodeKind::member;
    const Node& object = isMember ? node(it.child) : it;
    std::string name;
    if (object.kind == NodeKind::call) {
        name = sizeCall(isMember ? it.child : expression);
    } else if (isMember && object.kind == NodeKind::name &&
               unit_.bodies.roles[object.token] == WordRole::local) {
        const LocalVariable* found = keptLocal(object.token);
        if (found != nullptr && found->value != kNone) name = sizeCall(found->value);
    }
    if (!name.empty()) {
        constexpr std::string_view kNames = "xyzwrgbastpq";
        const std::string_view component = isMember ? text(it.token) : "x";
        const std::size_t axis = component.size() == 1 ? kNames.find(component) : std::string_view::npos;
        if (axis == std::string_view::npos) return false;
        to.steps.emplace_back(name + "." + "xyz"[std::min<std::size_t>(axis % 4, 2)]);
        return true;
    }
    const bool isLength = it.kind == NodeKind::method;
    if (isLength && (text(it.token) != "length" || it.end != it.token + 3)) return false;
    const Node& part = isLength ? node(it.child) : it;
    const Node& base = part.kind == NodeKind::member ? node(part.child) : part;
    if (base.kind != NodeKind::name || unit_.bodies.roles[base.token] != WordRole::global) return false;
    const bool isInstance = isBlockName(text(base.token), true);
    const bool isOfInstance = part.kind == NodeKind::member;
    if (isInstance != isOfInstance || (!isInstance && !isBlockName(text(base.token), false))) return false;
    name = text(base.token);
    if (isInstance) name += "." + std::string(text(part.token));
    if (isLength) name += ".length()";
    to.steps.emplace_back(std::move(name));
    return true;
}

}  // namespace glibra::glsl
