// Values, lists and programs that statements name.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/suggest.h"
#include "glib/number.h"
#include "glib/text.h"
#include "scene/modern/evaluate.h"
#include "scene/modern/modern.h"
#include "scene/modern/scope.h"
#include "scene/state.h"

namespace glibra::scene {

using glib::Value;

std::optional<expression::Value> constantOf(Interpreter& in, std::span<const Value> values) {
    if (values.size() == 1 && values[0].kind == Value::Kind::expression) return evaluate(in, values[0]);
    const auto numbers = numbersOf(in, values);
    if (!numbers || numbers->empty()) return std::nullopt;
    expression::Value value;
    if (numbers->size() > 4) {
        in.report(diagnose(
            "glib-E26", fmt::format("{} numbers are not a value here; write an expression", numbers->size()),
            in.place(values.front())));
        return std::nullopt;
    }
    value.type = values[0].kind == Value::Kind::truth ? expression::Type::boolean()
                                                      : expression::Type::vector(numbers->size());
    std::copy(numbers->begin(), numbers->end(), value.components.begin());
    return value;
}

std::optional<std::vector<double>> listOf(Interpreter& in, const Value& list) {
    if (list.count.empty()) return numbersOf(in, {&list, 1});
    const auto count = integerIn(in, list.count.front(), "the number of elements", 1, kMostVariableElements);
    if (!count || !countElements(in, list, *count)) return std::nullopt;
    constexpr double kMostComponents = 16.0 * kMostVariableElements;
    return elementsOf(in, list, list.items, *count, kMostComponents);
}

expression::Symbol counterSymbol() {
    expression::Symbol symbol;
    symbol.depends = expression::Depends::counter;
    return symbol;
}

std::optional<std::vector<double>> elementsOf(Interpreter& in, const Value& owner,
                                              std::span<const Value> element, int count, double most) {
    const InnerNames inner(in);
    Environment& names = in.shared->environment;
    const Environment::Slot counter = names.bind("i", counterSymbol());
    std::optional<std::vector<double>> all(std::in_place);
    for (double i = 0; i < count && all; ++i) {
        names.setNumber(counter, i);
        const auto numbers = numbersOf(in, element);
        if (!numbers) {
            all.reset();
        } else if (static_cast<double>(numbers->size()) * count > most) {
            in.report(diagnose(
                "glib-E15",
                fmt::format("{} elements of {} numbers; the limit is {} numbers", glib::groupedText(count),
                            numbers->size(), glib::groupedText(static_cast<long long>(most))),
                in.place(owner)));
            all.reset();
        } else {
            all->insert(all->end(), numbers->begin(), numbers->end());
        }
    }
    return all;
}

std::optional<ProgramIndex> programNamed(Interpreter& in, const Value& name, bool isCompute) {
    const auto computes = [&](ProgramIndex program) {
        return in.scene.programs[program].hasStage(glsl::Stage::compute);
    };
    const auto refuse = [&](std::string text) {
        in.report(diagnose("glib-E27", std::move(text), in.place(name)));
        return std::nullopt;
    };
    auto known = in.modern.programs.find(name.text);
    if (known == in.modern.programs.end()) known = in.modern.programs.find(wordBehind(in, name.text));
    if (known == in.modern.programs.end()) {
        if (isLost(in, name.text)) return std::nullopt;
        std::vector<std::string_view> names;
        for (const auto& [each, program] : in.modern.programs)
            if (computes(program) == isCompute) names.push_back(each);
        return refuse(fmt::format("no program '{}' is declared before this line{}", name.text,
                                  base::suggestion(name.text, names)));
    }
    if (computes(known->second) == isCompute) return known->second;
    return refuse(isCompute ? fmt::format("program '{}' has no compute stage; write Compute before its "
                                          "Program statement, because a stage is for one program alone",
                                          name.text)
                            : fmt::format("program '{}' has a compute stage; Dispatch runs it", name.text));
}

}  // namespace glibra::scene
