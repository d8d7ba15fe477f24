#include "scene/conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "base/text.h"
#include "glib/number.h"

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

/// A number, the components of a vector, "[1 0 2]", or the rows of a matrix, "[1 0] [0 1]".
std::string textOfValue(const expression::Value& value) {
    const bool areTruths = value.type.kind == expression::Kind::boolean;
    const auto textOf = [&](double each) {
        return !areTruths ? glib::numberText(each) : each != 0 ? "true" : "false";
    };
    if (value.all().size() == 1) return textOf(value.number());
    const std::size_t columns = value.type.columns, rows = value.type.rows;
    std::string text;
    for (std::size_t row = 0; row < (columns > 1 ? rows : 1); ++row) {
        text += row > 0 ? " [" : "[";
        for (std::size_t k = 0; k < (columns > 1 ? columns : rows); ++k)
            text += (k > 0 ? " " : "") + textOf(value.all()[columns > 1 ? k * rows + row : k]);
        text += "]";
    }
    return text;
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

bool ConditionNames::has(std::string_view path, bool isOfScene) const {
    return std::ranges::any_of(
        names_, [&](const Name& each) { return each.path == path && each.isOfScene == isOfScene; });
}

std::vector<ObjectView> ConditionNames::objects() const {
    std::vector<ObjectView> objects;
    for (const Name& each : names_) {
        if (each.buffer) objects.emplace_back(*each.buffer);
        if (each.measure && each.measure->of.object) objects.push_back(*each.measure->of.object);
    }
    return objects;
}

std::vector<Measure> ConditionNames::measures() const {
    std::vector<Measure> measures;
    for (const Name& each : names_)
        if (each.measure) measures.push_back(*each.measure);
    return measures;
}

void ConditionNames::readBuffers(const std::function<std::vector<double>(const BufferView& buffer)>& read) {
    for (Name& each : names_) {
        if (!each.buffer || each.elementSize == 0) continue;
        std::vector<double> numbers = read(*each.buffer);
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

void ConditionNames::measure(const std::function<Measured(const Measure& measure)>& value) {
    for (Name& each : names_) {
        if (!each.measure) continue;
        Measured found = value(*each.measure);
        each.has.assign(1, !found.components.empty());
        each.components = std::move(found.components);
        each.why = std::move(found.why);
        if (each.has.front()) each.symbol.type = found.type;
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

Result<Answer> answerTo(const glib::Value& expression, const ConditionNames& names, const std::string& file,
                        const expression::Wanted& wanted) {
    const glib::Position begin = glib::placeIn(expression, 0);
    const std::string& text = expression.text;
    const auto parsed = expression::parse(text, {file, begin.line, begin.column}, names, wanted);
    if (!parsed) return parsed.problem.message;
    const auto value = parsed->evaluate(names);
    if (!value) return value.problem.message;
    const std::string whole = textOfValue(*value), sides = sidesOf(text, names);
    return Answer{*value, whole, sides.empty() ? whole : sides};
}

std::vector<ObjectView> Check::objects() const {
    std::vector<ObjectView> objects;
    if (condition.names) objects = condition.names->objects();
    for (const auto& each : {of.object, other.object})
        if (each) objects.push_back(*each);
    return objects;
}

std::vector<double> Check::times() const {
    std::vector<double> times;
    if (seconds) times.push_back(*seconds);
    if (condition.names)
        for (const Measure& each : condition.names->measures())
            if (each.seconds) times.push_back(*each.seconds);
    return times;
}

std::vector<ObjectView> Print::objects() const {
    std::vector<ObjectView> objects;
    if (value.names) objects = value.names->objects();
    if (of.object) objects.push_back(*of.object);
    return objects;
}

Diagnostic notReached(const Check& condition, std::size_t rounds, const std::string& found) {
    return diagnose("glib-W43",
                    fmt::format("Repeat: {} is not true after {}: {}", condition.text,
                                base::counted(rounds, "round"), found),
                    condition.place);
}

}  // namespace glibra::scene
