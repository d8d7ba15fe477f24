#include "scene/modern/evaluate.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "scene/state.h"

namespace glibra::scene {
namespace {

/// Sets the names whose values depend on where the expression stands.
void supply(Interpreter& in, expression::Depends depends) {
    using expression::Depends;
    Environment& names = in.shared->environment;
    if (any(depends & Depends::model)) names.set("model", {&in.state.model[0][0], 16});
    if (any(depends & Depends::window)) {
        const std::array window{
            static_cast<double>(in.inputs.width > 0 ? in.inputs.width : in.scene.width),
            static_cast<double>(in.inputs.height > 0 ? in.inputs.height : in.scene.height)};
        names.set("window", window);
        names.setNumber("aspect", window[0] / window[1]);
    }
    if (!any(depends & Depends::camera)) return;
    SceneCamera seen;
    if (const SceneCamera* eye = findCamera(in, "eye")) {
        seen = *eye;
    } else {
        seen.view = in.scene.view;
        seen.projection = in.state.projection;
        names.setCamera("eye", valuesOf(in, seen));
    }
    names.setCamera("camera", valuesOf(in, seen));
}

ExpressionCache::Entry& entryOf(Interpreter& in, const glib::Value& value, const expression::Wanted& wanted) {
    const auto [known, isNew] = in.shared->expressions.entries.try_emplace(&value);
    if (!isNew) return known->second;
    const Place origin = in.script->place(glib::placeIn(value, 0));
    auto parsed = expression::parse(value.text, origin, in.shared->environment, wanted);
    if (parsed) {
        for (const expression::Use& each : parsed->uses())
            if (each.path.find(".prev.") != std::string::npos) in.shared->readsPrevious = true;
        known->second.expression = std::move(*parsed);
    } else {
        in.report(parsed.problem.message);
    }
    return known->second;
}

}  // namespace

std::optional<expression::Value> evaluate(Interpreter& in, const glib::Value& value,
                                          const expression::Wanted& wanted) {
    ExpressionCache::Entry& entry = entryOf(in, value, wanted);
    if (!entry.expression) return std::nullopt;
    supply(in, entry.expression->depends());
    in.shared->depends = in.shared->depends | entry.expression->depends();
    auto result = entry.expression->evaluate(in.shared->environment);
    if (result) return std::move(*result);
    if (!std::exchange(entry.isProblemReported, true)) in.report(result.problem.message);
    return std::nullopt;
}

std::optional<double> numberOf(Interpreter& in, const glib::Value& value) {
    using Kind = glib::Value::Kind;
    if (value.kind == Kind::number || value.kind == Kind::truth) return value.number;
    if (value.kind != Kind::expression) return std::nullopt;
    static constexpr expression::Type kTypes[] = {expression::Type::number(), expression::Type::boolean()};
    const auto result = evaluate(in, value, {.types = kTypes});
    return result ? std::optional(result->number()) : std::nullopt;
}

std::optional<bool> truthOf(Interpreter& in, const glib::Value& value) {
    const std::optional<double> number = numberOf(in, value);
    return number ? std::optional(*number != 0) : std::nullopt;
}

std::optional<std::vector<double>> numbersOf(Interpreter& in, std::span<const glib::Value> values) {
    std::vector<double> numbers;
    for (const glib::Value& each : values) {
        if (each.kind == glib::Value::Kind::expression) {
            const auto result = evaluate(in, each);
            if (!result) return std::nullopt;
            numbers.insert(numbers.end(), result->all().begin(), result->all().end());
        } else if (!each.items.empty()) {
            const auto inner = numbersOf(in, each.items);
            if (!inner) return std::nullopt;
            numbers.insert(numbers.end(), inner->begin(), inner->end());
        } else {
            numbers.push_back(each.number);
        }
    }
    return numbers;
}

std::optional<std::vector<double>> numbersOf(Interpreter& in, std::span<const glib::Value> values,
                                             std::size_t count, std::string_view what) {
    auto numbers = numbersOf(in, values);
    if (!numbers || numbers->size() == count) return numbers;
    const glib::Position position = values.empty() ? glib::Position{} : values.front().position;
    in.report(diagnose(
        "glib-E26", fmt::format("{} needs {} numbers; the values here have {}", what, count, numbers->size()),
        in.script->place(position)));
    return std::nullopt;
}

}  // namespace glibra::scene
