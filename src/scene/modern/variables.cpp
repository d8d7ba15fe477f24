// Variables, uniform variables of a scope, and materials (language, 12.1).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/suggest.h"
#include "scene/modern/evaluate.h"
#include "scene/modern/materials.h"
#include "scene/modern/modern.h"
#include "scene/state.h"

namespace glibra::scene {
namespace {

using glib::Command;
using glib::CommandId;
using glib::Value;

constexpr double kMostElements = 65'536;

Place placeOf(const Interpreter& in, const Value& value) {
    return in.script->place(value.position);
}

/// The value that the run gives a variable in place of the scene's, if it has as many components.
const std::vector<double>* chosenValue(Interpreter& in, const std::string& name, std::size_t components) {
    const auto chosen = in.inputs.variables.find(name);
    if (chosen == in.inputs.variables.end()) return nullptr;
    in.scene.usedVariables.insert(name);
    return chosen->second.size() == components ? &chosen->second : nullptr;
}

void declare(Interpreter& in, const Command& command, const std::string& name,
             const expression::Symbol& symbol, std::span<const double> components) {
    const auto slot = in.shared->environment.declare(name, symbol);
    if (!slot) {
        in.reportAt(command, "glib-E27", fmt::format("'{}' is declared above with another type", name));
        return;
    }
    const std::size_t size = symbol.type.size();
    for (std::size_t i = 0; i * size < components.size(); ++i)
        in.shared->environment.set(*slot, components.subspan(i * size, size), i);
}

expression::Symbol variable(expression::Type type, std::size_t count = 0) {
    expression::Symbol symbol;
    symbol.type = type;
    symbol.count = static_cast<std::uint32_t>(count);
    symbol.depends = expression::Depends::variable;
    return symbol;
}

/// A variable with a control: <min cur max>, <word word ...>, <true> or {r g b}.
void declareControl(Interpreter& in, const Command& command, const std::string& name, const Value& value) {
    Variable made;
    made.name = name;
    made.place = placeOf(in, value);
    const auto numbers = numbersOf(in, value.items);
    if (!numbers) return;
    made.written = *numbers;
    expression::Symbol symbol;
    if (value.kind == Value::Kind::color) {
        made.form = glib::UniformForm::color;
        symbol = variable(expression::Type::vector(made.written.size()));
    } else if (!value.items.empty() && value.items.front().kind == Value::Kind::word) {
        made.form = glib::UniformForm::range;
        for (const Value& each : value.items) made.words.push_back(each.text);
        made.written = {0, 0, static_cast<double>(made.words.size()) - 1};
        symbol = variable(expression::Type::number());
        symbol.words = made.words;
    } else if (value.items.size() == 1) {
        made.form = glib::UniformForm::truth;
        symbol = variable(expression::Type::boolean());
    } else {
        made.form = glib::UniformForm::range;
        symbol = variable(expression::Type::number());
        if (made.written.size() != 3 || made.written[0] > made.written[2]) {
            in.report(diagnose("glib-E26", fmt::format("'{}' needs <least current largest>", name),
                               placeOf(in, value)));
            return;
        }
    }
    const bool isRange = made.form == glib::UniformForm::range;
    made.current = isRange ? std::vector<double>{made.written[1]} : made.written;
    if (const std::vector<double>* chosen = chosenValue(in, name, made.current.size()))
        made.current = *chosen;
    declare(in, command, name, symbol, made.current);
    in.scene.variables.push_back(std::move(made));
}

void declareArray(Interpreter& in, const Command& command, const std::string& name, const Value& count,
                  const Value& value) {
    const auto wanted = numberOf(in, count);
    if (!wanted) return;
    if (!(*wanted >= 1 && *wanted <= kMostElements)) {
        in.report(diagnose("glib-E26",
                           fmt::format("'{}' cannot have {} elements; there are 1 to {}", name,
                                       std::trunc(*wanted), kMostElements),
                           placeOf(in, count)));
        return;
    }
    const auto elements = static_cast<std::size_t>(*wanted);
    Environment& names = in.shared->environment;
    names.beginScope();
    const Environment::Slot counter = names.declareScoped(&value, "i", [] {
        expression::Symbol symbol;
        symbol.depends = expression::Depends::counter;
        return symbol;
    }());
    // The expression may read earlier elements, so their type must be known before the expression can be
    // read.
    std::optional<expression::Type> type = in.shared->arrayTypes[&value];
    if (!type) {
        using expression::Type;
        for (const Type candidate : {Type::number(), Type::vector(3), Type::vector(4), Type::matrix(4),
                                     Type::vector(2), Type::matrix(3), Type::boolean(), Type::matrix(2)}) {
            Environment trial = names;
            trial.declare(name, variable(candidate, elements));
            const auto parsed =
                expression::parse(value.text, in.script->place(glib::placeIn(value, 0)), trial);
            if (!parsed || parsed->type() != candidate) continue;
            type = candidate;
            break;
        }
        in.shared->arrayTypes[&value] = type;
    }
    // Without a type the expression is wrong; evaluating it reports why.
    const auto slot = names.declare(name, variable(type.value_or(expression::Type::number()), elements));
    if (!slot)
        in.reportAt(command, "glib-E27", fmt::format("'{}' is declared above with another type", name));
    for (std::size_t i = 0; slot && i < elements; ++i) {
        const auto number = static_cast<double>(i);
        names.set(counter, {&number, 1});
        const auto element = evaluate(in, value);
        if (!element) break;
        names.set(*slot, element->all(), i);
    }
    names.endScope();
}

void doLet(Interpreter& in, const Command& command) {
    if (command.values.size() < 2) return;
    const Value& target = command.values[0];
    const Value& value = command.values[1];
    const std::string name = target.path.empty() ? target.text : target.path.front().name;
    const bool isArray = !target.path.empty() && !target.path.front().index.empty();
    if (isArray && value.kind == Value::Kind::expression)
        return declareArray(in, command, name, target.path.front().index.front(), value);
    switch (value.kind) {
        case Value::Kind::range:
        case Value::Kind::color:
            return declareControl(in, command, name, value);
        case Value::Kind::list: {
            const auto numbers = numbersOf(in, {&value, 1});
            if (!numbers || numbers->empty()) return;
            const bool isVector = numbers->size() >= 2 && numbers->size() <= 4 && !isArray;
            return declare(in, command, name,
                           isVector ? variable(expression::Type::vector(numbers->size()))
                                    : variable(expression::Type::number(), numbers->size()),
                           *numbers);
        }
        default:
            break;
    }
    auto result = constantOf(in, {&value, 1});
    if (!result) return;
    const expression::Value written = *result;
    if (const std::vector<double>* chosen = chosenValue(in, name, result->type.size()))
        std::copy(chosen->begin(), chosen->end(), result->components.begin());
    if (value.kind != Value::Kind::expression) {
        Variable made;
        made.name = name;
        made.place = placeOf(in, value);
        made.form = value.kind == Value::Kind::truth ? glib::UniformForm::truth : glib::UniformForm::number;
        made.written.assign(written.all().begin(), written.all().end());
        made.current.assign(result->all().begin(), result->all().end());
        in.scene.variables.push_back(std::move(made));
    }
    declare(in, command, name, variable(result->type), result->all());
}

/// Puts tags into the list of the scope; the last one of a name counts.
void addTags(Interpreter& in, std::span<const glib::KeyedValues> tags) {
    for (const glib::KeyedValues& each : tags) {
        std::erase_if(in.modern.set, [&](const ScopedTag& other) { return other.tag->key == each.key; });
        in.modern.set.push_back({&each, in.script});
    }
}

void doSet(Interpreter& in, const Command& command) {
    addTags(in, command.tags);
}

void doMaterial(Interpreter& in, const Command& command) {
    const std::string& name = command.values.front().text;
    const MaterialRow* row = findMaterial(name);
    if (row == nullptr) {
        const std::string hint = base::suggestion(name, materialNames());
        in.report(diagnose("glib-E27", fmt::format("no material '{}'{}", name, hint),
                           placeOf(in, command.values.front())));
        return;
    }
    addTags(in, row->tags);
}

void doUse(Interpreter& in, const Command& command) {
    const std::string& name = command.values.front().text;
    const auto known = in.modern.programs.find(name);
    if (known != in.modern.programs.end()) {
        in.state.program = known->second;
        return;
    }
    std::vector<std::string_view> names;
    for (const auto& [each, program] : in.modern.programs) names.push_back(each);
    const std::string hint = base::suggestion(name, names);
    in.report(diagnose("glib-E27", fmt::format("no program '{}' is declared before this line{}", name, hint),
                       placeOf(in, command.values.front())));
}

void doFps(Interpreter& in, const Command& command) {
    const auto rate = numberOf(in, command.values.front());
    if (!rate) return;
    constexpr double kLeast = 1e-3, kMost = 1e6;
    if (!(*rate >= kLeast && *rate <= kMost)) {
        in.report(diagnose("glib-E26", fmt::format("Fps: {} is not between {} and {}", *rate, kLeast, kMost),
                           placeOf(in, command.values.front())));
        return;
    }
    setFrameRate(in, *rate);
}

constexpr CommandAction kActions[] = {
    {CommandId::let, doLet, InList::isPart},
    {CommandId::set, doSet},
    {CommandId::material, doMaterial},
    {CommandId::use, doUse},
    {CommandId::fps, doFps},
};

}  // namespace

std::span<const CommandAction> variableActions() {
    return kActions;
}

std::optional<expression::Value> constantOf(Interpreter& in, std::span<const Value> values) {
    if (values.size() == 1 && values[0].kind == Value::Kind::expression) return evaluate(in, values[0]);
    const auto numbers = numbersOf(in, values);
    if (!numbers || numbers->empty()) return std::nullopt;
    expression::Value value;
    if (numbers->size() > 4) {
        in.report(diagnose("glib-E26",
                           fmt::format("{} numbers are no value here; write an expression", numbers->size()),
                           placeOf(in, values.front())));
        return std::nullopt;
    }
    value.type = values[0].kind == Value::Kind::truth ? expression::Type::boolean()
                                                      : expression::Type::vector(numbers->size());
    std::copy(numbers->begin(), numbers->end(), value.components.begin());
    return value;
}

namespace {

/// The tag with its values of this moment, in the form in which a Program line would state it.
std::optional<glib::UniformSpec> specOf(Interpreter& in, const glib::KeyedValues& tag) {
    glib::UniformSpec spec;
    spec.tag = tag.key;
    spec.tagPosition = tag.position;
    spec.valuePosition = tag.values.front().position;
    const Value& first = tag.values.front();
    if (first.kind == Value::Kind::word) {
        const auto symbol = in.shared->environment.find(first.text);
        if (!symbol || symbol->type.kind == expression::Kind::record) {
            const std::vector<std::string> names = in.shared->environment.known("");
            const std::vector<std::string_view> views(names.begin(), names.end());
            const std::string hint = base::suggestion(first.text, views);
            in.report(diagnose("glib-E27", fmt::format("'{}' is not a variable{}", first.text, hint),
                               placeOf(in, first)));
            return std::nullopt;
        }
        const std::size_t elements = std::max<std::size_t>(1, symbol->count);
        for (std::size_t i = 0; i < elements; ++i)
            if (const double* values = in.shared->environment.find(symbol->slot, i))
                spec.values.insert(spec.values.end(), values, values + symbol->type.size());
        spec.form =
            symbol->type.isBoolean() && elements == 1 ? glib::UniformForm::truth : glib::UniformForm::list;
    } else if (!first.count.empty()) {
        const auto count = numberOf(in, first.count.front());
        if (!count || !(*count >= 1 && *count <= kMostElements)) return std::nullopt;
        in.shared->environment.beginScope();
        expression::Symbol symbol;
        symbol.depends = expression::Depends::counter;
        const Environment::Slot counter = in.shared->environment.declareScoped(&first, "i", symbol);
        for (double i = 0; i < std::trunc(*count); ++i) {
            in.shared->environment.set(counter, {&i, 1});
            const auto numbers = numbersOf(in, first.items);
            if (!numbers) break;
            spec.values.insert(spec.values.end(), numbers->begin(), numbers->end());
        }
        in.shared->environment.endScope();
        spec.form = glib::UniformForm::list;
    } else if (first.kind == Value::Kind::expression && tag.values.size() == 1) {
        const auto value = evaluate(in, first);
        if (!value) return std::nullopt;
        spec.values.assign(value->all().begin(), value->all().end());
        spec.form = value->type.isBoolean() ? glib::UniformForm::truth : glib::UniformForm::list;
    } else {
        const auto numbers = numbersOf(in, tag.values);
        if (!numbers) return std::nullopt;
        spec.values = *numbers;
        spec.form = first.kind == Value::Kind::color   ? glib::UniformForm::color
                    : first.kind == Value::Kind::truth ? glib::UniformForm::truth
                    : first.kind == Value::Kind::range ? glib::UniformForm::range
                                                       : glib::UniformForm::list;
    }
    if (spec.values.empty()) return std::nullopt;
    if (spec.form == glib::UniformForm::list && spec.values.size() == 1)
        spec.form = glib::UniformForm::number;
    return spec;
}

}  // namespace

UniformSetIndex currentUniforms(Interpreter& in) {
    std::vector<glib::UniformSpec> set;
    const auto add = [&](const glib::KeyedValues& tag, const glib::Script* script, bool mayBeUnknown) {
        const glib::Script* const own = std::exchange(in.script, script);
        if (auto spec = specOf(in, tag)) {
            spec->mayBeUnknown = mayBeUnknown;
            std::erase_if(set, [&](const glib::UniformSpec& each) { return each.tag == spec->tag; });
            set.push_back(std::move(*spec));
        }
        in.script = own;
    };
    if (const auto tags = in.modern.programTags.find(in.state.program); tags != in.modern.programTags.end())
        for (const glib::KeyedValues& each : tags->second.command->tags)
            add(each, tags->second.script, false);
    for (const ScopedTag& each : in.modern.set) add(*each.tag, each.script, true);
    if (set.empty()) return {};
    std::vector<std::pair<std::string, std::vector<double>>> key;
    key.reserve(set.size());
    for (const glib::UniformSpec& each : set) key.emplace_back(each.tag, each.values);
    UniformSetIndex& index = in.uniformSets[std::move(key)];
    if (!index) index = in.scene.uniformSets.add(std::move(set));
    return index;
}

}  // namespace glibra::scene
