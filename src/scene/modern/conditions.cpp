#include "scene/modern/conditions.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "expression/expression.h"
#include "glib/number.h"
#include "scene/modern/environment.h"
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
        if (std::any_of(std::begin(kOthers), std::end(kOthers), isNext)) return std::nullopt;
        const auto* each = std::find_if(std::begin(kComparisons), std::end(kComparisons), isNext);
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
std::string sidesOf(std::string_view text, const Environment& names) {
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

Result<ConditionAnswer> answerCondition(
    const Check& check, Environment& names,
    const std::function<std::vector<double>(const std::string& buffer)>& read) {
    const glib::Position begin = glib::placeIn(*check.condition, 0);
    static constexpr expression::Type kTypes[] = {expression::Type::boolean(), expression::Type::number()};
    const std::string& text = check.condition->text;
    const auto parsed =
        expression::parse(text, {check.place.file, begin.line, begin.column}, names, {.types = kTypes});
    if (!parsed) return parsed.problem.message;
    for (const expression::Use& each : parsed->uses()) {
        if (!any(each.symbol.depends & expression::Depends::buffer)) continue;
        const std::string name = each.path.substr(0, each.path.find('.'));
        names.setElements(name, read(name));
    }
    const auto value = parsed->evaluate(names);
    if (!value) return value.problem.message;
    std::string found = sidesOf(text, names);
    if (found.empty()) found = textOfValue(*value);
    return ConditionAnswer{value->truth(), std::move(found)};
}

}  // namespace glibra::scene
