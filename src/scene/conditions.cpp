#include "scene/conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/text.h"
#include "expression/expression.h"
#include "glib/number.h"
#include "scene/scene.h"

namespace glibra::scene {
namespace {

struct ComparisonAt {
    std::size_t at = 0;
    std::string_view operation;
};

/// The operator that compares the two sides of the text; nothing if there is none or more than one, or if the
/// comparison is a part of something else.
std::optional<ComparisonAt> comparisonIn(std::string_view text) {
    static constexpr std::string_view kComparisons[] = {"==", "!=", "<=", ">=", "<", ">"};
    static constexpr std::string_view kOthers[] = {"&&", "||", "^^", "?"};
    std::optional<ComparisonAt> found;
    int depth = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::string_view rest = text.substr(at);
        const auto isNext = [&](std::string_view each) { return rest.starts_with(each); };
        depth += rest.front() == '(' || rest.front() == '[' ? 1 : 0;
        depth -= rest.front() == ')' || rest.front() == ']' ? 1 : 0;
        if (depth > 0) continue;
        if (std::ranges::any_of(kOthers, isNext)) return std::nullopt;
        const auto* each = std::ranges::find_if(kComparisons, isNext);
        if (each == std::end(kComparisons)) continue;
        if (found) return std::nullopt;
        found = ComparisonAt{at, *each};
        at += each->size() - 1;
    }
    return found;
}

/// A number, or the components of a vector or matrix: "[1 0 2]".
std::string textOfValue(const expression::Value& value) {
    if (value.type == expression::Type::boolean()) return value.truth() ? "true" : "false";
    if (value.all().size() == 1) return glib::numberText(value.number());
    std::string text;
    for (const double each : value.all()) text += (text.empty() ? "[" : " ") + glib::numberText(each);
    return text + "]";
}

/// The two sides of a comparison with their values; empty if the text is something else.
std::string sidesOf(std::string_view text, const ConditionNames& names) {
    const std::optional<ComparisonAt> comparison = comparisonIn(text);
    if (!comparison) return {};
    const auto valueOf = [&](std::string_view side) -> std::string {
        const auto parsed = expression::parse(side, {}, names);
        if (!parsed) return {};
        const auto value = parsed->evaluate(names);
        return value ? textOfValue(*value) : std::string();
    };
    const std::string left = valueOf(text.substr(0, comparison->at));
    const std::string right = valueOf(text.substr(comparison->at + comparison->operation.size()));
    if (left.empty() || right.empty()) return {};
    return left + " " + std::string(comparison->operation) + " " + right;
}

}  // namespace

void ConditionNames::add(Name name) {
    name.symbol.slot = static_cast<std::uint32_t>(names_.size());
    names_.push_back(std::move(name));
}

std::vector<std::string> ConditionNames::buffers() const {
    std::vector<std::string> buffers;
    for (const Name& each : names_)
        if (!each.buffer.empty() && std::ranges::find(buffers, each.buffer) == buffers.end())
            buffers.push_back(each.buffer);
    return buffers;
}

void ConditionNames::readBuffers(const std::function<std::vector<double>(const std::string& buffer)>& read) {
    for (Name& each : names_) {
        if (each.buffer.empty() || each.elementSize == 0) continue;
        std::vector<double> numbers = read(each.buffer);
        const std::size_t count = numbers.size() / each.elementSize;
        if (each.symbol.count > 0) {
            each.components = std::move(numbers);
            each.has.assign(count, true);
            each.why = fmt::format("'{}' has {} elements", each.path, count);
        } else {
            each.components = {static_cast<double>(count)};
            each.has = {true};
        }
    }
}

void ConditionNames::add(std::shared_ptr<const expression::Function> function) {
    functions_.push_back(std::move(function));
}

std::optional<expression::Symbol> ConditionNames::find(std::string_view path) const {
    const auto found =
        std::ranges::find_if(names_, [&](const Name& each) { return each.path == path && !each.isOfScene; });
    return found != names_.end() ? std::optional(found->symbol) : std::nullopt;
}

std::optional<expression::Symbol> ConditionNames::findInScene(std::string_view path) const {
    const auto found =
        std::ranges::find_if(names_, [&](const Name& each) { return each.path == path && each.isOfScene; });
    return found != names_.end() ? std::optional(found->symbol) : std::nullopt;
}

std::shared_ptr<const expression::Function> ConditionNames::findFunction(std::string_view name) const {
    for (const auto& each : functions_)
        if (each->name == name) return each;
    return nullptr;
}

std::vector<std::string> ConditionNames::known(std::string_view) const {
    return {};
}

const double* ConditionNames::find(std::uint32_t slot, std::size_t element) const {
    const Name& name = names_.at(slot);
    if (element >= name.has.size() || !name.has[element]) return nullptr;
    return &name.components[element * name.symbol.type.size()];
}

std::string ConditionNames::whyMissing(std::uint32_t slot, std::size_t) const {
    return names_.at(slot).why;
}

Result<ConditionAnswer> answerCondition(
    const Check& check, const std::function<std::vector<double>(const std::string& buffer)>& read) {
    const glib::Position begin = glib::placeIn(*check.condition, 0);
    static constexpr expression::Type kTypes[] = {expression::Type::boolean(), expression::Type::number()};
    const std::string& text = check.condition->text;
    ConditionNames names = *check.names;
    names.readBuffers(read);
    const auto parsed =
        expression::parse(text, {check.place.file, begin.line, begin.column}, names, {.types = kTypes});
    if (!parsed) return parsed.problem.message;
    const auto value = parsed->evaluate(names);
    if (!value) return value.problem.message;
    std::string found = sidesOf(text, names);
    if (found.empty()) found = textOfValue(*value);
    return ConditionAnswer{value->truth(), std::move(found)};
}

Diagnostic notReached(const Check& condition, std::size_t rounds, const std::string& found) {
    return diagnose("glib-W43",
                    fmt::format("Repeat: {} is not true after {}: {}", condition.text,
                                base::counted(rounds, "round"), found),
                    condition.place);
}

}  // namespace glibra::scene
