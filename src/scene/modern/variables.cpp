// Variables, lists and programs by their names (language, 12.1).

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/suggest.h"
#include "glib/number.h"
#include "scene/modern/evaluate.h"
#include "scene/modern/modern.h"
#include "scene/state.h"

namespace glibra::scene {
namespace {

using glib::Command;
using glib::CommandId;
using glib::Value;

constexpr int kMostVariableElements = 65'536;

/// The value that the run gives a variable in place of the scene's, if it has as many components.
const std::vector<double>* chosenValue(Interpreter& in, const std::string& name, std::size_t components) {
    const auto chosen = in.inputs.variables.find(name);
    if (chosen == in.inputs.variables.end()) return nullptr;
    in.scene.usedVariables.insert_or_assign(name, components);
    return chosen->second.size() == components ? &chosen->second : nullptr;
}

/// The number of the word that the run gives a choice. Reports a word that it does not have.
std::optional<double> chosenWord(Interpreter& in, const Variable& variable) {
    const auto chosen = in.inputs.words.find(variable.name);
    if (chosen == in.inputs.words.end() || variable.words.empty()) return std::nullopt;
    in.scene.usedVariables.insert_or_assign(variable.name, std::size_t{1});
    const auto found = std::find(variable.words.begin(), variable.words.end(), chosen->second);
    if (found != variable.words.end()) return static_cast<double>(found - variable.words.begin());
    const std::vector<std::string_view> words(variable.words.begin(), variable.words.end());
    in.report(
        diagnose("glib-E26",
                 fmt::format("'{}' is set to '{}', but it is one of {}{}", variable.name, chosen->second,
                             fmt::join(variable.words, ", "), base::suggestion(chosen->second, words)),
                 variable.place));
    return std::nullopt;
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

/// A file that is included twice declares its variables twice.
void addVariable(Interpreter& in, Variable variable) {
    const auto isSame = [&](const Variable& each) { return each.name == variable.name; };
    if (std::none_of(in.scene.variables.begin(), in.scene.variables.end(), isSame))
        in.scene.variables.push_back(std::move(variable));
}

/// True if a number that the run gives a choice counts one of its words; reports one that does not.
bool countsWord(Interpreter& in, const Variable& variable, double number) {
    const double last = static_cast<double>(variable.words.size()) - 1;
    if (variable.words.empty() || (number >= 0 && number <= last)) return true;
    in.report(diagnose(
        "glib-E26",
        fmt::format("'{}' is set to {}, but it is one of {}, which are 0 to {}", variable.name,
                    glib::numberText(number), fmt::join(variable.words, ", "), glib::numberText(last)),
        variable.place));
    return false;
}

/// Reports glib-W21 for a range whose current value is outside.
void checkCurrent(Interpreter& in, const Variable& variable) {
    const std::vector<double>& range = variable.written;
    if (range[1] >= range[0] && range[1] <= range[2]) return;
    in.report(diagnose(
        "glib-W21",
        fmt::format("{}: current value {} is outside {} ... {}; it is kept", variable.name,
                    glib::numberText(range[1]), glib::numberText(range[0]), glib::numberText(range[2])),
        variable.place));
}

/// A variable with a control: <min cur max>, <word word ...>, <true> or {r g b}.
void declareControl(Interpreter& in, const Command& command, const std::string& name, const Value& value) {
    Variable made;
    made.name = name;
    made.place = in.place(value);
    const auto numbers = numbersOf(in, value.items);
    if (!numbers) return;
    made.written = *numbers;
    expression::Symbol symbol;
    if (value.kind == Value::Kind::color) {
        if (made.written.size() < 3 || made.written.size() > 4) {
            in.report(diagnose(
                "glib-E26",
                fmt::format("'{}': a colour has 3 or 4 components, not {}", name, made.written.size()),
                in.place(value)));
            return;
        }
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
                               in.place(value)));
            return;
        }
        checkCurrent(in, made);
    }
    const bool isRange = made.form == glib::UniformForm::range;
    made.current = isRange ? std::vector<double>{made.written[1]} : made.written;
    const std::vector<double>* chosen = chosenValue(in, name, made.current.size());
    if (chosen != nullptr && countsWord(in, made, chosen->front())) made.current = *chosen;
    if (const auto word = chosenWord(in, made)) made.current = {*word};
    declare(in, command, name, symbol, made.current);
    addVariable(in, std::move(made));
}

void declareArray(Interpreter& in, const Command& command, const std::string& name, const Value& count,
                  const Value& value) {
    const auto wanted = numberOf(in, count);
    if (!wanted) return;
    if (!(*wanted >= 1 && *wanted <= kMostVariableElements)) {
        in.report(diagnose("glib-E26",
                           fmt::format("'{}' cannot have {} elements; there are 1 to {}", name,
                                       std::trunc(*wanted), kMostVariableElements),
                           in.place(count)));
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
    if (value.kind == Value::Kind::number) type = expression::Type::number();
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
        const auto element = constantOf(in, {&value, 1});
        if (!element) break;
        names.set(*slot, element->all(), i);
    }
    names.endScope();
}

/// What stands in the parentheses of [n of (...)].
std::string bodyOf(const Value& list) {
    const Value& item = list.items.front();
    return item.kind == Value::Kind::number ? glib::numberText(item.number) : item.text;
}

void declareVariable(Interpreter& in, const Command& command) {
    if (command.values.size() < 2) return;
    const Value& target = command.values[0];
    const Value& value = command.values[1];
    const std::string name = target.path.empty() ? target.text : target.path.front().name;
    const bool isArray = !target.path.empty() && !target.path.front().index.empty();
    const auto given = in.modern.given.find(name);
    const bool isGiven = given != in.modern.given.end();
    const bool isRule = value.kind == Value::Kind::list && !value.count.empty();
    const bool isComputed = value.kind == Value::Kind::expression || isRule || isGiven;
    if (!declareName(in, command, name,
                     isComputed ? DeclaredName::Kind::computed : DeclaredName::Kind::variable))
        return;
    const auto isSame = [&](const auto& each) { return each.first == name; };
    if (std::none_of(in.modern.variables.begin(), in.modern.variables.end(), isSame))
        in.modern.variables.emplace_back(name, command.position);
    if (isGiven) return declare(in, command, name, variable(given->second.type), given->second.all());
    if (isArray && isRule) {
        in.report(diagnose(
            "glib-E26",
            fmt::format("'{}' has two counts; write 'Let {} ({})'", name, target.text, bodyOf(value)),
            in.place(value)));
        return;
    }
    if (isRule) return declareArray(in, command, name, value.count.front(), value.items.front());
    if (isArray && isComputed)
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
        made.place = in.place(value);
        made.form = value.kind == Value::Kind::truth ? glib::UniformForm::truth : glib::UniformForm::number;
        made.written.assign(written.all().begin(), written.all().end());
        made.current.assign(result->all().begin(), result->all().end());
        addVariable(in, std::move(made));
    }
    declare(in, command, name, variable(result->type), result->all());
}

/// What Let sets in Once and Step is for the block alone: remembers what the variable was before it.
void keepBefore(Interpreter& in, const std::string& name) {
    if (in.modern.block == nullptr || in.modern.block->before.contains(name)) return;
    const auto symbol = in.shared->environment.findOutermost(name);
    in.modern.block->before.emplace(
        name, symbol ? std::optional(in.shared->environment.keep(symbol->slot)) : std::nullopt);
}

/// What a variable depends on passes to the expressions that read it.
void doLet(Interpreter& in, const Command& command) {
    const Value& target = command.values.front();
    const std::string& name = target.path.empty() ? target.text : target.path.front().name;
    keepBefore(in, name);
    const DependsOnly own(in);
    declareVariable(in, command);
    const auto symbol = in.shared->environment.find(name);
    if (symbol) in.shared->environment.addDepends(symbol->slot, own.depends() | in.modern.conditions);
}

void doUse(Interpreter& in, const Command& command) {
    if (const auto program = programNamed(in, command.values.front(), false)) in.state.program = *program;
}

void doFps(Interpreter& in, const Command& command) {
    const auto rate = numberOf(in, command.values.front());
    if (!rate) return;
    constexpr double kLeast = 1e-3, kMost = 1e6;
    if (!(*rate >= kLeast && *rate <= kMost)) {
        in.report(diagnose("glib-E26", fmt::format("Fps: {} is not between {} and {}", *rate, kLeast, kMost),
                           in.place(command.values.front())));
        return;
    }
    in.shared->frameRate = *rate;
    setTime(in);
}

constexpr CommandAction kVariableActions[] = {
    {CommandId::let, doLet, InList::isPart},
    {CommandId::use, doUse},
    {CommandId::fps, doFps},
};

}  // namespace

std::span<const CommandAction> variableActions() {
    return kVariableActions;
}

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
    if (!count) return std::nullopt;
    constexpr double kMostComponents = 16.0 * kMostVariableElements;
    return elementsOf(in, list, list.items, *count, kMostComponents);
}

std::optional<std::vector<double>> elementsOf(Interpreter& in, const Value& owner,
                                              std::span<const Value> element, int count, double most) {
    Environment& names = in.shared->environment;
    names.beginScope();
    expression::Symbol symbol;
    symbol.depends = expression::Depends::counter;
    const Environment::Slot counter = names.declareScoped(&owner, "i", symbol);
    std::optional<std::vector<double>> all(std::in_place);
    for (double i = 0; i < count && all; ++i) {
        names.set(counter, {&i, 1});
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
    names.endScope();
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
